% SPDX-License-Identifier: MIT
function plot_roll(file)
% PLOT_ROLL  Roll angle, roll rate and canards of a flight over time.
%
%   plot_roll('out/export/tasha3_launch2.mat')
log = load_flight(file);
columns = {'roll_angle_deg', 'roll_rate_deg_s', 'canard_deg'};
names = {'roll angle', 'roll rate', 'canards'};
for i = 1:numel(columns)
  subplot(numel(columns), 1, i);
  plot(log.flight.time_s, log.flight.(columns{i}));
  grid on;
  ylabel(sprintf('%s / %s', names{i}, log.units.(columns{i})));
end
xlabel('time / s');
end
