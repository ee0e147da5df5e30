using Engraver.Simulator.Language;

namespace Engraver.Simulator.Motion;

/// <summary>One coordinate system, S or T: the path profiler (galil-dmc.md B). Speeds counts/s along the path, lengths counts.</summary>
internal sealed class VectorPlane(char letter)
{
    private readonly double[] _point = new double[Axis.Letters.Length];
    private readonly int[] _origin = new int[Axis.Letters.Length];
    private readonly int[] _joint = new int[Axis.Letters.Length];
    private Axis[] _axes = [];
    private double _commanded = 25000;
    private int _stopCode;

    public char Letter => letter;

    public PlaneMode Mode { get; private set; }

    public ReadOnlySpan<Axis> Axes => _axes;

    public SegmentBuffer Buffer { get; } = new();

    public TangentFollower Tangent { get; } = new();

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

    /// <summary>The buffer ran empty without VE (B.7): the plane stands until it is fed, closed or aborted.</summary>
    public bool IsDry { get; private set; }

    /// <summary>How often the buffer ran dry since power up.</summary>
    public int Underruns { get; private set; }

    /// <summary>Where the next AV counts from (B.1).</summary>
    public double TrippointReference { get; set; }

    /// <summary>True when the next sample will move something.</summary>
    public bool CanProgress => IsActive && (Speed > 0 || IsStopping || (Buffer.IsEmpty ? Buffer.IsClosed || !IsDry : _commanded * SpeedRatio > 0));

    /// <summary>A running sequence moves the axis, along the path or its tangent.</summary>
    public bool Drives(Axis axis) => IsActive && (Tangent.Axis == axis || Array.IndexOf(_axes, axis) >= 0);

    public bool IsAtSpeed => IsActive && Speed == _commanded * SpeedRatio;

    /// <summary>Slot 1 to n of the frame as absolute counts at the last segment joint: <c>_VPx</c>.</summary>
    public int JointOf(Axis axis)
    {
        var i = Array.IndexOf(_axes, axis);
        return i < 0 ? axis.Reference : _origin[i] + _joint[i];
    }

    public void SetSpeed(double speed)
    {
        VectorSpeed = speed;
        _commanded = speed;
    }

    /// <summary>VM or LM: new axes, empty buffer.</summary>
    public void SetUp(PlaneMode mode, Axis[] newAxes, Axis? tangentAxis)
    {
        Mode = mode;
        _axes = newAxes;
        Tangent.Axis = tangentAxis;
        Clear();
    }

    /// <summary>CS: removes what was stored (B.1).</summary>
    public void Clear()
    {
        Buffer.Clear();
        SegmentIndex = 0;
        Travelled = 0;
    }

    /// <summary>The end of the last stored segment in the sequence frame, one number per axis.</summary>
    public ReadOnlySpan<double> FrameEnd => Buffer.FrameEnd[.._axes.Length];

    public void Store(VectorSegment segment)
    {
        PrepareForSegment();
        var next = Buffer.IsEmpty;
        Buffer.Store(segment);
        if (next && IsActive) EnterSegment();
    }

    /// <summary>VE or LE.</summary>
    public void Close() => Buffer.IsClosed = true;

    /// <summary>A stored sequence that was executed makes room for the next one by itself; CS is not needed then (B.1).</summary>
    public void PrepareForSegment()
    {
        if (IsActive && Buffer.IsClosed) throw new CommandRefusedException(Tc.NotWhileRunning);

        if (!IsActive && Buffer.IsEmpty && (SegmentIndex > 0 || Buffer.Length > 0)) Clear();

        Buffer.IsClosed = false;
    }

    /// <summary>BGS: latches the frame origin at the present position (B.2).</summary>
    public void Begin()
    {
        if (Buffer.IsEmpty) throw new CommandRefusedException(Tc.NoSequence);

        for (var i = 0; i < _axes.Length; i++)
        {
            _origin[i] = _axes[i].Reference;
            _joint[i] = 0;
        }

        IsActive = true;
        IsStopping = false;
        IsDry = false;
        Speed = 0;
        Travelled = 0;
        SegmentIndex = 0;
        TrippointReference = 0;
        Tangent.Restart();
        _commanded = VectorSpeed;
        MarkAxes(StopCode.VectorRunning);
        EnterSegment();
    }

    /// <summary>STS or a limit: brakes at VD, the rest of the sequence is given up (B.8). A dry plane is not helped by it; that needs VE or AB1 (B.7).</summary>
    public void Stop(int code)
    {
        if (IsActive && !IsStopping && !IsDry)
        {
            IsStopping = true;
            _stopCode = code;
            MarkAxes(code);
        }
    }

    /// <summary>AB: at once, without a ramp; the buffer is emptied.</summary>
    public void Halt(int code)
    {
        if (IsActive) End(code);
    }

    /// <summary>One sample. The sample may lie in several segments: time is split at the joints, so every point lies on the path.</summary>
    /// <returns>True when something moved or the sequence ended.</returns>
    public bool Step()
    {
        var before = Travelled;
        var left = Ramp.Sample;
        while (left > 1e-12 && IsActive && HasPath())
        {
            var used = Advance(Buffer.Current!, left);
            if (used <= 0) break;

            left -= used;
        }

        if (IsActive && Travelled != before) MoveAxes();

        return Travelled != before || !IsActive;
    }

    private bool HasPath()
    {
        if (!Buffer.IsEmpty)
        {
            IsDry = false;
            return true;
        }

        if (Buffer.IsClosed || IsStopping)
        {
            MoveAxes();
            End(IsStopping ? _stopCode : StopCode.VectorDone);
            return false;
        }

        Underruns += IsDry ? 0 : 1;
        IsDry = true;
        Speed = 0;
        return false;
    }

    private double Advance(VectorSegment segment, double dt)
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
        if (distance >= remaining - 1e-7) return Cross(segment, remaining, acceleration, used);

        Travelled += distance;
        Speed = next;
        if (Speed > 0 || !IsStopping) return used;

        MoveAxes();
        End(_stopCode);
        return 0;
    }

    private double Cross(VectorSegment segment, double remaining, double acceleration, double dt)
    {
        var end = Math.Sqrt(Math.Max(0, (Speed * Speed) + (2 * acceleration * remaining)));
        var used = Speed + end <= 0 ? dt : Math.Min(dt, 2 * remaining / (Speed + end));
        Travelled = segment.EndLength;
        Speed = end;
        segment.PointAt(segment.Length, _point);
        for (var i = 0; i < _axes.Length; i++) _joint[i] = Rounded(_point[i]);

        Tangent.Follow(segment.TangentAt(segment.Length));
        Buffer.Drop();
        SegmentIndex++;
        EnterSegment();
        return HasPath() ? Math.Max(used, 1e-9) : 0;
    }

    private double NextSpeed(VectorSegment segment, double dt)
    {
        var target = IsStopping ? 0 : _commanded * SpeedRatio;
        var ceiling = double.PositiveInfinity;
        var toEnd = segment.EndLength - Travelled;
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

        if (Buffer.IsClosed)
            ceiling = Math.Min(ceiling, Ramp.Braking(Speed, Buffer.Length - Travelled, 0, Deceleration, dt));

        var slowest = Speed - (Deceleration * dt);
        var towards = target == 0 ? slowest : Ramp.Towards(Speed, target, Acceleration, Deceleration, dt);
        return Speed == 0 && target == 0 ? 0 : Math.Max(slowest, Math.Min(ceiling, towards));
    }

    private void EnterSegment() => _commanded = Buffer.Current?.EntrySpeed ?? _commanded;

    private void MoveAxes()
    {
        if (Buffer.Current is { } segment)
        {
            segment.PointAt(Travelled - segment.StartLength, _point);
            Tangent.Follow(segment.TangentAt(Travelled - segment.StartLength));
        }

        for (var i = 0; i < _axes.Length; i++)
        {
            _axes[i].SetPosition(_origin[i] + Rounded(_point[i]));
        }
    }

    private void End(int code)
    {
        IsActive = false;
        IsStopping = false;
        IsDry = false;
        Speed = 0;
        Buffer.Abandon();
        foreach (var axis in _axes) axis.LastStop = axis.Reference;

        MarkAxes(code);
    }

    private void MarkAxes(int code)
    {
        foreach (var axis in _axes) axis.StopCode = code;
    }

    private static int Rounded(double value) => (int)Math.Round(value, MidpointRounding.AwayFromZero);
}
