namespace Engraver.Simulator.Motion;

/// <summary>The trapezoid along the path of one plane (galil-dmc.md B.4, B.5). Speeds counts/s, lengths counts, times seconds.</summary>
internal sealed class PathProfile(SegmentBuffer buffer, SimulatorOptions options)
{
    private double _commanded = 25000;
    private double _earlier;
    private long _earlierSegments;
    private double _steadyFrom;
    private long _steadySamples;

    public double VectorSpeed { get; private set; } = 25000;

    public double Acceleration { get; set; } = 256000;

    public double Deceleration { get; set; } = 256000;

    /// <summary>VR: 0 to 10, scales every speed of the plane (B.4).</summary>
    public double SpeedRatio { get; set; } = 1;

    public bool IsStopping { get; set; }

    /// <summary>The plane brakes for the end of the closed sequence: bit "final deceleration" of the status word (A.9).</summary>
    public bool IsEnding { get; private set; }

    /// <summary>Present commanded speed: <c>_VMS</c>.</summary>
    public double Speed { get; private set; }

    /// <summary>Path length from the start of the sequence: <c>_AVS</c>.</summary>
    public double Travelled { get; private set; }

    /// <summary>Path length of all sequences since power up, which only grows; a gear follows it (B.6).</summary>
    public double Odometer => _earlier + Travelled;

    /// <summary>Index of the segment being executed, from 0; after the end of the sequence the number of executed segments: <c>_CSS</c>.</summary>
    public int SegmentIndex { get; private set; }

    /// <summary>Segments executed since power up, over all sequences.</summary>
    public long SegmentsExecuted => _earlierSegments + SegmentIndex;

    public bool IsAtSpeed => Speed == Target;

    /// <summary>The next sample of a path with segments moves an axis.</summary>
    public bool IsDriving => Speed > 0 || IsStopping || Target > 0;

    private double Target => (EarlyExit ?? _commanded) * SpeedRatio;

    /// <summary>The exit speed of the executing segment if its ramp begins at the start of the segment, otherwise null. An exit speed of 0 is reached as late
    /// as possible, because a path that rests earlier never reaches the end of its segment.</summary>
    private double? EarlyExit => options.EarlyRamps && buffer.Current?.ExitSpeed is > 0 and var exit ? exit : null;

    /// <summary>VS; takes effect at once, also in motion, except in a segment with a speed of its own.</summary>
    public void SetSpeed(double speed)
    {
        VectorSpeed = speed;
        if (!options.OwnEntrySpeed || buffer.Current?.EntrySpeed is null) _commanded = speed;
    }

    public void Clear()
    {
        _steadySamples = 0;
        _earlier += Travelled;
        _earlierSegments += SegmentIndex;
        SegmentIndex = 0;
        Travelled = 0;
    }

    public void Begin()
    {
        Clear();
        IsStopping = false;
        _steadySamples = 0;
        Speed = 0;
        _commanded = VectorSpeed;
        EnterSegment();
    }

    public void EnterSegment() => _commanded = buffer.Current?.EntrySpeed ?? (options.OwnEntrySpeed ? VectorSpeed : _commanded);

    public void SetAtRest()
    {
        _steadySamples = 0;
        Speed = 0;
        IsEnding = false;
    }

    /// <summary>Advances by <paramref name="dt"/> or to the end of the segment, whichever comes first.</summary>
    /// <param name="crossed">True when the end of the segment was reached; the segment has then been removed from the buffer.</param>
    /// <returns>The time used.</returns>
    public double Advance(VectorSegment segment, double dt, out bool crossed)
    {
        var next = NextSpeed(segment, dt, Travelled);
        var acceleration = (next - Speed) / dt;
        var used = dt;
        if (next < 0)
        {
            used = dt * Speed / (Speed - next);
            next = 0;
        }

        var distance = (Speed + next) / 2 * used;
        var remaining = segment.EndLength - Travelled;
        crossed = distance >= remaining - 1e-7;
        if (crossed) return Cross(segment, remaining, acceleration, used);
        Go(distance, isSteady: next == Speed && used == Ramp.Sample);
        Speed = next;
        return used;
    }

    /// <summary>Number of samples for which the speed stays constant and the segment does not end; 0 when the next sample can change either.</summary>
    /// <remarks>The speed limit never rises along a segment, so that testing the last of the samples is sufficient. The search need not find the largest
    /// number: the remaining samples are stepped.</remarks>
    public long SteadySamples(VectorSegment segment, long atMost)
    {
        if (Speed <= 0 || Speed != Target || IsStopping || IsEnding) return 0;
        if (_steadySamples == 0) _steadyFrom = Travelled;
        var step = Speed * Ramp.Sample;
        var samples = Math.Min(atMost, SamplesOver(Math.Min(segment.EndLength - Travelled, DistanceToChange(segment)), step));
        if (samples < SteadyMotion.Shortest) return 0;
        while (samples > 0 && NextSpeed(segment, Ramp.Sample, Travelled + ((samples - 1) * step)) != Speed) samples /= 2;
        IsEnding = false;
        return samples;
    }

    /// <summary>Advances at the present speed by the given number of <see cref="SteadySamples"/>; the position is equal to that of single steps to the last
    /// bit.</summary>
    public void PassSteady(long samples)
    {
        var step = Speed * Ramp.Sample;
        _steadySamples += samples;
        Travelled = _steadyFrom + (_steadySamples * step);
    }

    /// <summary>Sets the path length to its value after the given number of samples, so that conditions can be tested; <see cref="PassSteady"/> must
    /// follow.</summary>
    public void ShowSteady(long samples) => Travelled = TravelledAfter(samples);

    /// <summary>Path length after the given number of further samples at constant speed.</summary>
    public double TravelledAfter(long samples) => _steadyFrom + ((_steadySamples + samples) * (Speed * Ramp.Sample));

    /// <summary>The terms of <see cref="TravelledAfter"/>: path length at which constant speed started, samples since then, distance of one sample.</summary>
    public (double From, long Samples, double Step) SteadyState => (_steadyFrom, _steadySamples, Speed * Ramp.Sample);

    private static long SamplesOver(double length, double step)
    {
        const double Max = 1e15;
        return (long)Math.Clamp((length / step) - 3, 0, Max);
    }

    /// <summary>Path length to the point at which braking or the exit speed can change the speed; approximate, because the speed itself is tested
    /// afterwards.</summary>
    private double DistanceToChange(VectorSegment segment)
    {
        var end = buffer.IsClosed ? buffer.Length - Travelled - (Speed * Speed / (2 * Deceleration)) : double.PositiveInfinity;
        if (segment.ExitSpeed is not { } exit) return end;
        exit *= SpeedRatio;
        var change = Math.Abs((exit * exit) - (Speed * Speed)) / (2 * (exit <= Speed ? Deceleration : Acceleration));
        return Math.Min(end, segment.EndLength - Travelled - change);
    }

    /// <summary>Advances the path length. At constant speed it is a number of samples times the distance of one sample, so that rounding does not accumulate
    /// and a jump ends exactly where single samples end.</summary>
    private void Go(double distance, bool isSteady)
    {
        if (isSteady)
        {
            _steadyFrom = _steadySamples == 0 ? Travelled : _steadyFrom;
            PassSteady(1);
            return;
        }

        _steadySamples = 0;
        Travelled += distance;
    }

    private double Cross(VectorSegment segment, double remaining, double acceleration, double dt)
    {
        var end = Math.Sqrt(Math.Max(0, (Speed * Speed) + (2 * acceleration * remaining)));
        var used = Speed + end <= 0 ? dt : Math.Min(dt, 2 * remaining / (Speed + end));
        Travelled = segment.EndLength;
        _steadySamples = 0;
        Speed = end;
        buffer.Drop();
        SegmentIndex++;
        EnterSegment();
        return Math.Max(used, 1e-9);
    }

    private double NextSpeed(VectorSegment segment, double dt, double travelled)
    {
        var target = IsStopping ? 0 : Target;
        var ceiling = double.PositiveInfinity;
        var toEnd = segment.EndLength - travelled;
        if (!IsStopping && EarlyExit is null && segment.ExitSpeed is { } exit)
        {
            exit *= SpeedRatio;
            if (exit <= target) ceiling = Ramp.Braking(Speed, toEnd, exit, Deceleration, dt);
            else if (toEnd <= ((exit * exit) - (Speed * Speed)) / (2 * Acceleration)) target = exit;
        }

        var slowest = Speed - (Deceleration * dt);
        var towards = target == 0 ? slowest : Ramp.Towards(Speed, target, Acceleration, Deceleration, dt);
        var end = buffer.IsClosed ? Ramp.Braking(Speed, buffer.Length - travelled, 0, Deceleration, dt) : double.PositiveInfinity;
        IsEnding = end < towards && !IsStopping;
        ceiling = Math.Min(ceiling, end);
        return Speed == 0 && target == 0 ? 0 : Math.Max(slowest, Math.Min(ceiling, towards));
    }
}
