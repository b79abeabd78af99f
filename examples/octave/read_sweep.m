% octave examples/octave/read_sweep.m, from the root of the repository: computes the shipped sweep and asks how often designs snap.
program = getenv('FLEXSLIP');
if isempty(program), program = 'flexslip'; end
here = fileparts(mfilename('fullpath'));
file = [tempname() '.h5'];
status = system(['"' program '" sweep "' fullfile(here, '..', 'sweep.toml') '" --output "' file '" --quiet']);
assert(status == 0, 'flexslip did not succeed: see the message above');

if exist('OCTAVE_VERSION', 'builtin')
  sweep = load('-hdf5', file);
  snaps = double(sweep.outcomes.snaps(:));
  state = sweep.outcomes.status(:);
  stiffness = sweep.axes.stiffness(:);
  wavelength = sweep.axes.wavelength(:);
  mu0 = sweep.axes.mu0(:);
else
  snaps = double(h5read(file, '/outcomes/snaps'));
  state = h5read(file, '/outcomes/status');
  stiffness = h5read(file, '/axes/stiffness');
  wavelength = h5read(file, '/axes/wavelength');
  mu0 = h5read(file, '/axes/mu0');
end
delete(file);

% The last axis of the file runs fastest, and columns come first here: so the axes come in the reverse order.
snaps = reshape(snaps, [numel(mu0), numel(wavelength), numel(stiffness)]);
computed = double(state(:) == 0);
fprintf('%d designs, %d computed, %d of them snap\n', numel(snaps), sum(computed), sum(snaps(:) > 0));
for i = [1, round(numel(stiffness)/2), numel(stiffness)]
  share = mean(mean(snaps(:, :, i) > 0));
  fprintf('at %.0f N/m %.0f %% of the designs snap\n', stiffness(i), 100*share);
end
