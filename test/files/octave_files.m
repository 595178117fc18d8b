% SPDX-License-Identifier: MIT
% Made octave_v6.mat and octave_v7.mat, with GNU Octave 7.3: octave-cli octave_files.m
flight.time_s = (0:0.25:0.5)';
flight.row = [1.5 -2.5 1e-300];
flight.logical = [true; false; true];
flight.int8 = int8([-7; 0; 127]);
flight.single = single([0.5; 1.5; 2.5]);
flight.phase = {'armed'; 'launched'; 'launched'};
flight.status = ['ok   '; 'error'; 'ok   '];
flight.mass_kg = 12.5;          % no column, like the three below
flight.matrix = eye(3);
flight.impedance = [1; 2i; 3];
flight.made_by = 'Octave';
save('-v6', 'octave_v6.mat', 'flight');
save('-v7', 'octave_v7.mat', 'flight');
