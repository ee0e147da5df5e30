namespace Engraver.Simulator.Motion;

/// <summary>The trapezoid along the path of one plane (galil-dmc.md B.4, B.5). Speeds counts/s, lengths counts, times seconds.</summary>
internal sealed class PathProfile(SegmentBuffer buffer)
{
    private double _commanded = 25000;
    private double _earlier;

    public double VectorSpeed { get; private set; } = 25000;

    public double Acceleration { get; set; } = 256000;

    public double Deceleration { get; set; } = 256000;

    /// <summary>VR: 0 to 10, scales every speed of the plane (B.4).</summary>
    public double SpeedRatio { get; set; } = 1;

    public bool IsStopping { get; set; }

    /// <summary>It brakes for the end of the closed sequence: the final deceleration of the status word (A.9).</summary>
    public bool IsEnding { get; private set; }

    /// <summary>Momentary commanded speed: <c>_VMS</c>.</summary>
    public double Speed { get; private set; }

    /// <summary>Path length from the start of the sequence: <c>_AVS</c>.</summary>
    public double Travelled { get; private set; }

    /// <summary>Path length of all sequences since power up: what a gear follows, always forwards (B.6).</summary>
    public double Odometer => _earlier + Travelled;

    /// <summary>Index of the segment being executed, from 0; after the end the number executed: <c>_CSS</c>.</summary>
    public int SegmentIndex { get; private set; }

    public bool IsAtSpeed => Speed == Target;

    /// <summary>The next sample of a path with segments moves something.</summary>
    public bool WantsToMove => Speed > 0 || IsStopping || Target > 0;

    private double Target => _commanded * SpeedRatio;

    /// <summary>VS, at once and also in motion.</summary>
    public void SetSpeed(double speed)
    {
        VectorSpeed = speed;
        _commanded = speed;
    }

    public void Clear()
    {
        _earlier += Travelled;
        SegmentIndex = 0;
        Travelled = 0;
    }

    public void Begin()
    {
        Clear();
        IsStopping = false;
        Speed = 0;
        _commanded = VectorSpeed;
        EnterSegment();
    }

    public void EnterSegment() => _commanded = buffer.Current?.EntrySpeed ?? _commanded;

    public void StandStill()
    {
        Speed = 0;
        IsEnding = false;
    }

    /// <summary>Goes on for <paramref name="dt"/> or to the end of the segment, whichever comes first.</summary>
    /// <param name="crossed">True at the end of the segment, which then has left the buffer.</param>
    /// <returns>The time used.</returns>
    public double Advance(VectorSegment segment, double dt, out bool crossed)
    {
        var next = NextSpeed(segment, dt);
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
        Travelled += distance;
        Speed = next;
        return used;
    }

    private double Cross(VectorSegment segment, double remaining, double acceleration, double dt)
    {
        var end = Math.Sqrt(Math.Max(0, (Speed * Speed) + (2 * acceleration * remaining)));
        var used = Speed + end <= 0 ? dt : Math.Min(dt, 2 * remaining / (Speed + end));
        Travelled = segment.EndLength;
        Speed = end;
        buffer.Drop();
        SegmentIndex++;
        EnterSegment();
        return Math.Max(used, 1e-9);
    }

    private double NextSpeed(VectorSegment segment, double dt)
    {
        var target = IsStopping ? 0 : Target;
        var ceiling = double.PositiveInfinity;
        var toEnd = segment.EndLength - Travelled;
        if (!IsStopping && segment.ExitSpeed is { } exit)
        {
            exit *= SpeedRatio;
            if (exit <= target) ceiling = Ramp.Braking(Speed, toEnd, exit, Deceleration, dt);
            else if (toEnd <= ((exit * exit) - (Speed * Speed)) / (2 * Acceleration)) target = exit;
        }

        var slowest = Speed - (Deceleration * dt);
        var towards = target == 0 ? slowest : Ramp.Towards(Speed, target, Acceleration, Deceleration, dt);
        var end = buffer.IsClosed ? Ramp.Braking(Speed, buffer.Length - Travelled, 0, Deceleration, dt) : double.PositiveInfinity;
        IsEnding = end < towards && !IsStopping;
        ceiling = Math.Min(ceiling, end);
        return Speed == 0 && target == 0 ? 0 : Math.Max(slowest, Math.Min(ceiling, towards));
    }
}
