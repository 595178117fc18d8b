% SPDX-License-Identifier: MIT
function model = roll_model(file, window_s, inertia_kg_m2, area_m2)
% ROLL_MODEL  Damping alpha, torque constant beta and disturbance u_d of a flight, by linear least squares.
%
%   model = roll_model('out/export/tasha3_launch2.mat', [0.9 8], 0.00393, 5.0265e-5)
%
% fits, over the window,
%
%   I p' = -1/2 rho v A alpha p + 1/2 rho v^2 A beta (u + u_d)
%
% with p the roll rate, u the canards, v the speed, and u_d a straight line over time. So that no noisy rate has to be
% differentiated, both sides are integrated: the rate is its value at the begin, less alpha times the integral of
% 1/2 rho v A p / I, and so on. That is linear in what is sought. The density is 1.225 exp(-h / 8500) kg/m3, as in
% `fantail identify` for a log that climbs.
%
% This is the whole idea in thirty lines. `fantail identify` fits the roll angle instead of the rate, says how well each
% number is known, and doubts the model where it does not hold.
log = load_flight(file);
f = log.flight;
inside = f.time_s >= window_s(1) & f.time_s <= window_s(2);
t = f.time_s(inside);
p = f.roll_rate_deg_s(inside) * pi / 180;
u = f.canard_deg(inside) * pi / 180;
v = f.speed_m_s(inside);
rho = 1.225 * exp(-f.height_m(inside) / 8500);

damping = 0.5 * rho .* v * area_m2 / inertia_kg_m2;
torque = 0.5 * rho .* v.^2 * area_m2 / inertia_kg_m2;
since = (t - t(1)) / (t(end) - t(1));
regressors = [ones(size(t)), -cumtrapz(t, damping .* p), cumtrapz(t, torque .* u), ...
              cumtrapz(t, torque), cumtrapz(t, torque .* since)];
found = regressors \ p;

model.alpha_m2 = found(2);
model.beta_m = found(3);
model.disturbance_deg = [found(4), found(4) + found(5)] / found(3) * 180 / pi;  % at the begin and at the end
model.rate_error_deg_s = sqrt(mean((regressors * found - p).^2)) * 180 / pi;
end
