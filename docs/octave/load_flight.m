% SPDX-License-Identifier: MIT
function log = load_flight(file)
% LOAD_FLIGHT  A flight that `fantail log export --to mat` wrote, for MATLAB and GNU Octave.
%
%   log = load_flight('out/export/tasha3_launch2.mat')
%
%   log.flight.roll_rate_deg_s   one column for each field; NaN: nobody knew it at that tick
%   log.units.roll_rate_deg_s    'deg/s'
%   log.words.phase              the words behind the numbers of log.flight.phase
%   log.about.plan               the flight plan; also vehicle, versions, events, gaps
%
% Ticks to which no replay leads have no replayed values; they are left out here.
log = load(file);
if ~isfield(log.flight, 'replayed')
  return;  % exported with --fields, without it
end
replayed = log.flight.replayed == 1;
names = fieldnames(log.flight);
for i = 1:numel(names)
  log.flight.(names{i}) = log.flight.(names{i})(replayed);
end
end
