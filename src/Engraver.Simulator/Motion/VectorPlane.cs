using Engraver.Simulator.Language;

namespace Engraver.Simulator.Motion;

/// <summary>One coordinate system, S or T: segment buffer and path profiler (galil-dmc.md B). Speeds counts/s along the path, lengths counts.</summary>
/// <remarks>The executing segment still occupies its slot, so that free slots are 511 - (segments stored - _CS) at any time (F.1).</remarks>
internal sealed class VectorPlane(char letter)
{
    public const int Slots = 511;
    private const double LongestSequence = 2e9;

    private readonly Queue<VectorSegment> buffer = new(Slots);
    private readonly double[] segmentEnd = new double[Axis.Letters.Length];
    private readonly double[] point = new double[Axis.Letters.Length];
    private readonly int[] origin = new int[Axis.Letters.Length];
    private Axis[] axes = [];
    private double total;
    private double commanded = 25000;
    private double? tangent;
    private int stopCode;

    public char Letter => letter;

    public PlaneMode Mode { get; private set; }

    public ReadOnlySpan<Axis> Axes => axes;

    /// <summary>The axis that VM drives along the tangent, or null (B.6).</summary>
    public Axis? TangentAxis { get; private set; }

    /// <summary>TN: counts per degree and the position that means zero degrees.</summary>
    public (double PerDegree, double Zero) TangentScale { get; set; }

    public double VectorSpeed { get; private set; } = 25000;

    public double Acceleration { get; set; } = 256000;

    public double Deceleration { get; set; } = 256000;

    /// <summary>VR: 0 to 10, scales every speed of the plane (B.4).</summary>
    public double SpeedRatio { get; set; } = 1;

    /// <summary>BGS was given and the sequence has not come to its end: <c>_BGS</c>.</summary>
    public bool IsActive { get; private set; }

    public bool IsStopping { get; private set; }

    /// <summary>Momentary commanded speed: <c>_VMS</c>.</summary>
    public double Speed { get; private set; }

    /// <summary>Path length from the start of the sequence: <c>_AVS</c>.</summary>
    public double Travelled { get; private set; }

    /// <summary>Index of the segment being executed, from 0; after the end the number executed: <c>_CSS</c>.</summary>
    public int SegmentIndex { get; private set; }

    /// <summary>VE or LE stands behind the last segment.</summary>
    public bool IsClosed { get; private set; }

    /// <summary>The buffer ran empty without VE (B.7): the plane stands until it is fed, closed or aborted.</summary>
    public bool IsDry { get; private set; }

    /// <summary>How often the buffer ran dry since power up.</summary>
    public int Underruns { get; private set; }

    public int FreeSlots => Slots - buffer.Count;

    public double StoredLength => total;

    /// <summary>Where the next AV counts from (B.1).</summary>
    public double TrippointReference { get; set; }

    /// <summary>True when the next sample will move something.</summary>
    public bool CanProgress => IsActive && (Speed > 0 || (buffer.Count > 0 && !IsStopping && commanded * SpeedRatio > 0) || IsStopping || (buffer.Count == 0 && (IsClosed || !IsDry)));

    public bool IsAtSpeed => IsActive && Speed == commanded * SpeedRatio;

    /// <summary>Slot 1 to n of the frame as absolute counts at the last segment joint: <c>_VPx</c>.</summary>
    public int JointOf(Axis axis)
    {
        int i = Array.IndexOf(axes, axis);
        return i < 0 ? axis.Reference : origin[i] + joint[i];
    }

    private readonly int[] joint = new int[Axis.Letters.Length];

    public void SetSpeed(double speed)
    {
        VectorSpeed = speed;
        commanded = speed;
    }

    /// <summary>VM or LM: new axes, empty buffer.</summary>
    public void SetUp(PlaneMode mode, Axis[] newAxes, Axis? tangentAxis)
    {
        Mode = mode;
        axes = newAxes;
        TangentAxis = tangentAxis;
        Clear();
    }

    /// <summary>CS: removes what was stored (B.1).</summary>
    public void Clear()
    {
        buffer.Clear();
        Array.Clear(segmentEnd);
        total = 0;
        IsClosed = false;
        SegmentIndex = 0;
        Travelled = 0;
    }

    /// <summary>The end of the last stored segment in the sequence frame; after a CR it is a real point (I, rounding rule).</summary>
    public ReadOnlySpan<double> FrameEnd => segmentEnd.AsSpan(0, axes.Length);

    public void Store(VectorSegment segment)
    {
        PrepareForSegment();
        if (segment.Length < 1e-3)
        {
            throw new CommandRefusedException(Tc.SegmentTooShort);
        }

        if (buffer.Count >= Slots)
        {
            throw new CommandRefusedException(Tc.SegmentBufferFull);
        }

        if (total + segment.Length > LongestSequence)
        {
            throw new CommandRefusedException(Tc.SequenceTooLong);
        }

        segment.StartLength = total;
        total += segment.Length;
        segment.PointAt(segment.Length, segmentEnd);
        buffer.Enqueue(segment);
        Enter(buffer.Count == 1 && IsActive);
    }

    /// <summary>VE or LE.</summary>
    public void Close() => IsClosed = true;

    /// <summary>A stored sequence that was executed makes room for the next one by itself; CS is not needed then (B.1).</summary>
    public void PrepareForSegment()
    {
        if (IsActive && IsClosed)
        {
            throw new CommandRefusedException(Tc.NotWhileRunning);
        }

        if (!IsActive && buffer.Count == 0 && (SegmentIndex > 0 || total > 0))
        {
            Clear();
        }

        IsClosed = IsClosed && IsActive;
    }

    /// <summary>BGS: latches the frame origin at the present position (B.2).</summary>
    public void Begin()
    {
        if (buffer.Count == 0)
        {
            throw new CommandRefusedException(Tc.NoSequence);
        }

        for (int i = 0; i < axes.Length; i++)
        {
            origin[i] = axes[i].Reference;
            joint[i] = 0;
        }

        IsActive = true;
        IsStopping = false;
        IsDry = false;
        Speed = 0;
        Travelled = 0;
        SegmentIndex = 0;
        TrippointReference = 0;
        tangent = null;
        commanded = VectorSpeed;
        MarkAxes(StopCode.VectorRunning);
        Enter(true);
    }

    /// <summary>STS or a limit: brakes at VD, the rest of the sequence is given up (B.8). A dry plane is not helped by it; that needs VE or AB1 (B.7).</summary>
    public void Stop(int code)
    {
        if (IsActive && !IsStopping && !IsDry)
        {
            IsStopping = true;
            stopCode = code;
            MarkAxes(code);
        }
    }

    /// <summary>AB: at once, without a ramp; the buffer is emptied.</summary>
    public void Halt(int code)
    {
        if (IsActive)
        {
            End(code);
        }
    }

    /// <summary>One sample. The sample may lie in several segments: time is split at the joints, so every point lies on the path.</summary>
    /// <returns>True when something moved or the sequence ended.</returns>
    public bool Step()
    {
        double before = Travelled;
        double left = Ramp.Sample;
        while (left > 1e-12 && IsActive && HasPath())
        {
            double used = Advance(buffer.Peek(), left);
            if (used <= 0)
            {
                break;
            }

            left -= used;
        }

        if (IsActive && Travelled != before)
        {
            MoveAxes();
        }

        return Travelled != before || !IsActive;
    }

    private bool HasPath()
    {
        if (buffer.Count > 0)
        {
            IsDry = false;
            return true;
        }

        if (IsClosed || IsStopping)
        {
            MoveAxes();
            End(IsStopping ? stopCode : StopCode.VectorDone);
            return false;
        }

        Underruns += IsDry ? 0 : 1;
        IsDry = true;
        Speed = 0;
        return false;
    }

    private double Advance(VectorSegment segment, double dt)
    {
        double next = NextSpeed(segment, dt);
        double acceleration = (next - Speed) / dt;
        double used = dt;
        if (next < 0)
        {
            used = dt * Speed / (Speed - next);
            next = 0;
        }

        double distance = (Speed + next) / 2 * used;
        double remaining = segment.EndLength - Travelled;
        if (distance >= remaining - 1e-7)
        {
            return Cross(segment, remaining, acceleration, used);
        }

        Travelled += distance;
        Speed = next;
        if (Speed > 0 || !IsStopping)
        {
            return used;
        }

        MoveAxes();
        End(stopCode);
        return 0;
    }

    private double Cross(VectorSegment segment, double remaining, double acceleration, double dt)
    {
        double end = Math.Sqrt(Math.Max(0, (Speed * Speed) + (2 * acceleration * remaining)));
        double used = Speed + end <= 0 ? dt : Math.Min(dt, 2 * remaining / (Speed + end));
        Travelled = segment.EndLength;
        Speed = end;
        segment.PointAt(segment.Length, point);
        for (int i = 0; i < axes.Length; i++)
        {
            joint[i] = Rounded(point[i]);
        }

        tangent = segment.TangentAt(segment.Length);
        buffer.Dequeue();
        SegmentIndex++;
        Enter(true);
        return HasPath() ? Math.Max(used, 1e-9) : 0;
    }

    private double NextSpeed(VectorSegment segment, double dt)
    {
        double target = IsStopping ? 0 : commanded * SpeedRatio;
        double ceiling = double.PositiveInfinity;
        double toEnd = segment.EndLength - Travelled;
        if (!IsStopping && segment.ExitSpeed is { } exit)
        {
            exit *= SpeedRatio;
            if (exit <= target)
            {
                ceiling = Ramp.Braking(Speed, toEnd, exit, Deceleration, dt);
            }
            else if (toEnd <= ((exit * exit) - (Speed * Speed)) / (2 * Acceleration))
            {
                target = exit;
            }
        }

        if (IsClosed)
        {
            ceiling = Math.Min(ceiling, Ramp.Braking(Speed, total - Travelled, 0, Deceleration, dt));
        }

        double slowest = Speed - (Deceleration * dt);
        double towards = target == 0 ? slowest : Ramp.Towards(Speed, target, Acceleration, Deceleration, dt);
        return Speed == 0 && target == 0 ? 0 : Math.Max(slowest, Math.Min(ceiling, towards));
    }

    private void Enter(bool executing)
    {
        if (executing && buffer.TryPeek(out var segment) && segment.EntrySpeed is { } entry)
        {
            commanded = entry;
        }
    }

    private void MoveAxes()
    {
        if (buffer.TryPeek(out var segment))
        {
            segment.PointAt(Travelled - segment.StartLength, point);
        }

        for (int i = 0; i < axes.Length; i++)
        {
            axes[i].SetPosition(origin[i] + Rounded(point[i]));
        }

        if (TangentAxis is not null)
        {
            TurnTangentAxis(segment);
        }
    }

    /// <summary>Position the tangent axis needs at the start of the sequence: <c>_TNS</c>.</summary>
    public double TangentStart() => buffer.TryPeek(out var first)
        ? TangentScale.Zero + (TangentScale.PerDegree * Unwound(first.TangentAt(0), 0))
        : TangentScale.Zero;

    private void TurnTangentAxis(VectorSegment? segment)
    {
        if (segment is not null)
        {
            tangent = Unwound(segment.TangentAt(Travelled - segment.StartLength), tangent ?? 0);
        }

        TangentAxis!.SetPosition(Math.Round(TangentScale.Zero + (TangentScale.PerDegree * tangent.GetValueOrDefault()), MidpointRounding.AwayFromZero));
    }

    private void End(int code)
    {
        IsActive = false;
        IsStopping = false;
        IsDry = false;
        Speed = 0;
        buffer.Clear();
        foreach (var axis in axes)
        {
            axis.LastStop = axis.Reference;
        }

        MarkAxes(code);
    }

    private void MarkAxes(int code)
    {
        foreach (var axis in axes)
        {
            axis.StopCode = code;
        }
    }

    private static double Unwound(double angle, double near) => near + Math.IEEERemainder(angle - near, 360);

    private static int Rounded(double value) => (int)Math.Round(value, MidpointRounding.AwayFromZero);
}
