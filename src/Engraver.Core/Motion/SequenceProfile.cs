using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>Speed over path and time of one sequence as the controller runs it, from rest to rest (galil-dmc.md B.4, B.5): from the start of each segment it
/// goes to the commanded speed at the acceleration of the sequence, and brakes so that it comes to rest at the end of the last one.</summary>
/// <remarks>Lengths are counts along the sequence, speeds counts/s, times seconds from its start.</remarks>
public sealed class SequenceProfile
{
    private readonly double _acceleration;

    /// <summary>Phases of constant acceleration: their starts, and one entry more for the end.</summary>
    private readonly List<double> _paths = [];
    private readonly List<double> _seconds = [];
    private readonly List<double> _speeds = [];

    private SequenceProfile(double acceleration) => _acceleration = acceleration;

    public double Length => _paths[^1];

    public double Seconds => _seconds[^1];

    /// <summary>The highest speed that is reached.</summary>
    public double Peak => _speeds.Max();

    /// <summary>Path lengths at which the acceleration changes, with start and end.</summary>
    public IReadOnlyList<double> Changes => _paths;

    /// <summary>The profile of a sequence on a machine.</summary>
    public static SequenceProfile Of(VectorSequence sequence, MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(sequence);
        ArgumentNullException.ThrowIfNull(profile);
        return Of(sequence, sequence.AccelerationOn(profile));
    }

    /// <param name="sequence">Its own <see cref="VectorSequence.Acceleration"/> is not read.</param>
    /// <param name="acceleration">VA and VD, counts/s2, above 0.</param>
    public static SequenceProfile Of(VectorSequence sequence, double acceleration)
    {
        ArgumentNullException.ThrowIfNull(sequence);
        var profile = new SequenceProfile(acceleration);
        var walk = new ProfileWalk(sequence.Length, acceleration);
        profile.Add(walk);
        if (!sequence.HasOwnSpeeds)
        {
            walk.BeginSegment(sequence.Length, sequence.Speed);
            while (walk.Next()) profile.Add(walk);
            return profile;
        }

        foreach (var segment in sequence.Segments)
        {
            walk.BeginSegment(segment.Length, sequence.SpeedOf(segment));
            while (walk.Next()) profile.Add(walk);
        }

        return profile;
    }

    /// <summary>Seconds of a sequence, without a profile of it.</summary>
    public static double SecondsOf(VectorSequence sequence, MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(sequence);
        var acceleration = sequence.AccelerationOn(profile);
        if (!sequence.HasOwnSpeeds) return SpeedTrapezoid.Time(sequence.Length, sequence.Speed, acceleration);
        var walk = new ProfileWalk(sequence.Length, acceleration);
        for (var i = 0; i < sequence.Segments.Count; i++)
        {
            var segment = sequence.Segments[i];
            walk.BeginSegment(segment.Length, sequence.SpeedOf(segment));
            while (walk.Next())
            {
            }
        }

        return walk.Seconds;
    }

    /// <summary>Speed along the path; 0 before and after it.</summary>
    public double SpeedAt(double path)
    {
        if (path <= 0.0 || path >= Length) return 0.0;
        var phase = PhaseAt(path);
        return Math.Sqrt(Math.Max(0.0, (_speeds[phase] * _speeds[phase]) + (2.0 * GainOf(phase) * (path - _paths[phase]))));
    }

    /// <summary>Acceleration along the path, counts/s2: positive where it becomes faster.</summary>
    public double GainAt(double path) => path < 0.0 || path > Length ? 0.0 : GainOf(PhaseAt(path));

    /// <summary>Path length after a time; between 0 and <see cref="Length"/>.</summary>
    public double PathAt(double seconds)
    {
        if (seconds <= 0.0) return 0.0;
        if (seconds >= Seconds) return Length;
        var phase = IndexBefore(_seconds, seconds);
        var since = seconds - _seconds[phase];
        return Math.Min(_paths[phase + 1], _paths[phase] + (since * (_speeds[phase] + (0.5 * GainOf(phase) * since))));
    }

    /// <summary>Speed after a time.</summary>
    public double SpeedAfter(double seconds)
    {
        if (seconds <= 0.0 || seconds >= Seconds) return 0.0;
        var phase = IndexBefore(_seconds, seconds);
        return Math.Max(0.0, _speeds[phase] + (GainOf(phase) * (seconds - _seconds[phase])));
    }

    /// <summary>Seconds until a path length is reached.</summary>
    public double SecondsAt(double path)
    {
        if (path <= 0.0) return 0.0;
        if (path >= Length) return Seconds;
        var phase = PhaseAt(path);
        var (speed, there) = (_speeds[phase], SpeedAt(path));
        return _seconds[phase] + (speed + there > 0.0 ? 2.0 * (path - _paths[phase]) / (speed + there) : 0.0);
    }

    private void Add(ProfileWalk walk)
    {
        _paths.Add(walk.Path);
        _seconds.Add(walk.Seconds);
        _speeds.Add(walk.Speed);
    }

    private int PhaseAt(double path) => IndexBefore(_paths, path);

    private double GainOf(int phase) => _speeds[phase + 1] > _speeds[phase] ? _acceleration : _speeds[phase + 1] < _speeds[phase] ? -_acceleration : 0.0;

    /// <summary>The last phase that begins at a value or before it.</summary>
    private static int IndexBefore(List<double> starts, double value)
    {
        var (low, high) = (0, starts.Count - 2);
        while (low < high)
        {
            var middle = (low + high + 1) / 2;
            if (starts[middle] <= value) low = middle;
            else high = middle - 1;
        }

        return low;
    }

    /// <summary>Goes through a sequence phase by phase. The brake to rest at the end follows v2 = 2 a (length - path).</summary>
    private sealed class ProfileWalk(double length, double acceleration)
    {
        /// <summary>Lengths below this are not a phase, counts.</summary>
        private const double Nothing = 1e-9;

        private double _end;
        private double _target;
        private bool _isEnding;

        public double Path { get; private set; }

        public double Seconds { get; private set; }

        public double Speed { get; private set; }

        public void BeginSegment(double segment, double target) => (_end, _target) = (_end + segment, target);

        /// <summary>Goes to the end of the next phase in the segment.</summary>
        /// <returns>False at its end.</returns>
        public bool Next()
        {
            var left = _end - Path;
            if (left <= Nothing) return false;
            if (_isEnding) return Go(left, -acceleration);
            var brake = length - (Speed * Speed / (2.0 * acceleration)) - Path; // where the brake to rest begins at this speed
            if (brake <= Nothing)
            {
                _isEnding = true;
                return Go(left, -acceleration);
            }

            var square = (_target * _target) - (Speed * Speed);
            if (square > 0.0) return Go(Math.Min(left, Math.Min(square / (2.0 * acceleration), brake / 2.0)), acceleration, square / (2.0 * acceleration) <= Math.Min(left, brake / 2.0) ? _target : null);
            if (square < 0.0) return Go(Math.Min(left, -square / (2.0 * acceleration)), -acceleration, -square / (2.0 * acceleration) <= left ? _target : null);
            return Go(Math.Min(left, brake), 0.0, Speed);
        }

        private bool Go(double way, double gain, double? speed = null)
        {
            var there = speed ?? Math.Sqrt(Math.Max(0.0, (Speed * Speed) + (2.0 * gain * way)));
            if (Speed + there > 0.0) Seconds += 2.0 * way / (Speed + there);
            (Path, Speed) = (Path + way, there);
            return true;
        }
    }
}
