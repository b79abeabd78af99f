% octave examples/octave/fit_and_plot.m, from the root of the repository: fits the shipped test and draws measured and fitted force.
% The program is that of the environment variable FLEXSLIP, or the one on the path. Runs in MATLAB R2016b or newer, too.
program = getenv('FLEXSLIP');
if isempty(program), program = 'flexslip'; end
here = fileparts(mfilename('fullpath'));
case_file = fullfile(here, '..', 'simulated', 'case.toml');

[status, text] = system(['"' program '" fit "' case_file '" --json --quiet']);
assert(status == 0, 'flexslip did not succeed: see the message above');
fit = jsondecode(text);
mu0 = fit.parameters.mu0;
fprintf('mu0 = %.4f, 95 %% interval %.4f to %.4f\n', mu0.value, mu0.interval95(1), mu0.interval95(2));
fprintf('%d drops, the median of %.1f uN\n', numel(fit.drops), 1e6*median([fit.drops.force_fall]));

% The table of the same fit: one line of titles with units, then numbers; NaN where there is none.
table_file = [tempname() '.csv'];
system(['"' program '" fit "' case_file '" --quiet --curves "' table_file '" --output "' tempname() '"']);
lines = strsplit(fileread(table_file), "\n");
titles = strsplit(lines{1}, ',');
values = dlmread(table_file, ',', 1, 0);
delete(table_file);
deflection = values(:, find(strncmp(titles, 'w [', 3), 1));
force = values(:, find(strncmp(titles, 'F [', 3), 1));
fprintf('%d rows, greatest force %.3f mN\n', numel(force), 1e3*max(force));

if ~isempty(getenv('DRAW'))  % DRAW=1: a window
  plot(1e6*deflection, 1e3*force, '.');
  xlabel('deflection (um)'); ylabel('force (mN)');
end
