using Engraver.Simulator.Motion.Following;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Motion;

/// <summary>One coordinate system, S or T: sequences of segments over its axes (galil-dmc.md B).</summary>
internal sealed class VectorPlane
{
    private readonly double[] _point = new double[Axis.Letters.Length];
    private readonly int[] _origin = new int[Axis.Letters.Length];
    private readonly int[] _joint = new int[Axis.Letters.Length];
    private Axis[] _axes = [];
    private double _firstScale = 1;
    private double _secondScale = 1;
    private int _stopCode;

    public VectorPlane(char letter, SimulatorOptions options)
    {
        Letter = letter;
        Buffer = new SegmentBuffer(options.OnePendingExit);
        Profile = new PathProfile(Buffer, options);
    }

    public char Letter { get; }

    public PlaneMode Mode { get; private set; }

    public ReadOnlySpan<Axis> Axes => _axes;

    public SegmentBuffer Buffer { get; }

    public PathProfile Profile { get; }

    public TangentFollower Tangent { get; } = new();

    /// <summary>VT: the fraction of the distance to the profile that the axes cover in one sample; 1 means no smoothing (B.1).</summary>
    public double Smoothing { get; set; } = 1;

    /// <summary>BGS was given and the sequence, including its smoothing, has not ended: <c>_BGS</c>.</summary>
    public bool IsActive => IsRunning || Array.Exists(_axes, static a => a.IsSmoothing);

    /// <summary>The path profile has not ended.</summary>
    public bool IsRunning { get; private set; }

    /// <summary>The buffer became empty without VE (B.7): the axes wait until segments arrive or the sequence is closed or aborted.</summary>
    public bool IsDry { get; private set; }

    /// <summary>Number of times that the buffer ran dry since power up.</summary>
    public int Underruns { get; private set; }

    /// <summary>Path length from which the next AV counts (B.1).</summary>
    public double TrippointReference { get; set; }

    /// <summary>True when the next sample will move an axis.</summary>
    public bool CanProgress => IsRunning && (Buffer.IsEmpty ? Buffer.IsClosed || !IsDry || Profile.IsStopping : Profile.IsDriving);

    public bool IsAtSpeed => IsRunning && Profile.IsAtSpeed;

    /// <summary>The end of the last stored segment in the sequence frame, one number per axis.</summary>
    public ReadOnlySpan<double> FrameEnd => Buffer.FrameEnd[.._axes.Length];

    /// <summary>A running sequence moves the axis, along the path or its tangent.</summary>
    public bool Drives(Axis axis) => IsRunning && (Tangent.Axis == axis || Array.IndexOf(_axes, axis) >= 0);

    /// <summary>Position of an axis of the frame, absolute counts, at the last segment end: <c>_VPx</c>.</summary>
    public int JointOf(Axis axis)
    {
        var i = Array.IndexOf(_axes, axis);
        return i < 0 ? axis.Reference : _origin[i] + _joint[i];
    }

    /// <summary>Called when the position value of an axis has been shifted while the path continues.</summary>
    public void Renumber(Axis axis, double difference)
    {
        var i = Array.IndexOf(_axes, axis);
        if (i >= 0) _origin[i] += (int)difference;
        if (Tangent.Axis == axis) Tangent.Zero += difference;
    }

    /// <summary>VM or LM: sets the axes, empties the buffer, removes scaling.</summary>
    public void SetUp(PlaneMode mode, Axis[] newAxes, Axis? tangentAxis)
    {
        Mode = mode;
        _axes = newAxes;
        Tangent.Axis = tangentAxis;
        (_firstScale, _secondScale) = (1, 1);
        Clear();
    }

    /// <summary>ES m,n: the distance of the axis with the smaller number is multiplied by the quotient (B.1).</summary>
    public void Scale(double m, double n) => (_firstScale, _secondScale) = (Math.Max(1, m / n), Math.Max(1, n / m));

    /// <summary>CS: removes the stored segments (B.1).</summary>
    public void Clear()
    {
        Buffer.Clear();
        Profile.Clear();
    }

    public void Store(VectorSegment segment)
    {
        PrepareForSegment();
        var next = Buffer.IsEmpty;
        Buffer.Store(segment);
        if (next && IsRunning) Profile.EnterSegment();
    }

    /// <summary>Closes the sequence: VE or LE.</summary>
    public void Close() => Buffer.IsClosed = true;

    /// <summary>Called before a segment is stored: removes a sequence that has been executed, so that CS is not needed (B.1).</summary>
    public void PrepareForSegment()
    {
        if (IsRunning && Buffer.IsClosed) throw new CommandRefusedException(Tc.NotWhileRunning);
        if (!IsRunning && Buffer.IsEmpty && (Profile.SegmentIndex > 0 || Buffer.Length > 0)) Clear();
        Buffer.IsClosed = false;
    }

    /// <summary>BGS: sets the frame's origin to the present position (B.2).</summary>
    public void Begin()
    {
        if (Buffer.IsEmpty) throw new CommandRefusedException(Tc.NoSequence);
        for (var i = 0; i < _axes.Length; i++)
        {
            _origin[i] = _axes[i].Reference;
            _joint[i] = 0;
            _axes[i].Smoothing = Smoothing;
        }

        IsRunning = true;
        IsDry = false;
        TrippointReference = 0;
        Tangent.Restart();
        Profile.Begin();
        MarkAxes(StopCode.VectorRunning);
    }

    /// <summary>STS or a limit: brakes at VD and discards the rest of the sequence (B.8). It does not end a plane that ran out of segments; this requires VE or
    /// AB1 (B.7).</summary>
    public void Stop(int code)
    {
        if (!IsRunning || Profile.IsStopping || IsDry) return;
        Profile.IsStopping = true;
        _stopCode = code;
        MarkAxes(code);
    }

    /// <summary>AB: stops at once, without a ramp, and empties the buffer.</summary>
    public void Halt(int code)
    {
        if (IsRunning) End(code);
    }

    /// <summary>Computes one sample, which can extend over several segments: its time is divided at their ends, so that every point is on the path.</summary>
    /// <returns>True when an axis moved or the sequence ended.</returns>
    public bool Step()
    {
        var before = Profile.Travelled;
        var left = Ramp.Sample;
        while (left > 1e-12 && IsRunning && HasPath())
        {
            var segment = Buffer.Current!;
            var used = Profile.Advance(segment, left, out var crossed);
            if (crossed) PassJoint(segment);
            else if (Profile is { IsStopping: true, Speed: 0 }) EndAtPresentPlace(_stopCode);
            if (used <= 0 || (crossed && !HasPath())) break;
            left -= used;
        }

        if (IsRunning && Profile.Travelled != before) MoveAxes();
        return Profile.Travelled != before || !IsRunning;
    }

    /// <summary>Number of samples for which the speed stays constant within one segment and no axis changes direction; 0 when the next sample must be
    /// stepped.</summary>
    public long SteadySamples(long atMost)
    {
        if (IsDry || Tangent.Axis is not null || Buffer.Current is not { } segment || !CanBeCourse(segment)) return 0;
        var samples = Profile.SteadySamples(segment, atMost);
        if (samples == 0) return 0;
        var oneWay = segment.StartLength + segment.OneWayUntil(Profile.Travelled - segment.StartLength) - Profile.Travelled;
        return Math.Min(samples, (long)(oneWay / (Profile.Speed * Ramp.Sample)));
    }

    /// <summary>Sets the axes to their positions after the given number of samples at constant speed.</summary>
    public void PlaceSteady(long samples)
    {
        Profile.ShowSteady(samples);
        MoveAxes();
    }

    /// <summary>The positions of the axes from now on at constant speed.</summary>
    public PathCourse Course() => new(Buffer.Current!, Profile, _axes, _origin, _firstScale, _secondScale);

    /// <summary>An arc has a closed form only when its two axes are A and B, or when neither of them is A or B.</summary>
    private bool CanBeCourse(VectorSegment segment) => segment is not CircularSegment || _axes[0].Index < 2 == _axes[1].Index < 2;

    private bool HasPath()
    {
        if (!Buffer.IsEmpty)
        {
            IsDry = false;
            return true;
        }

        if (Buffer.IsClosed || Profile.IsStopping)
        {
            EndAtPresentPlace(Profile.IsStopping ? _stopCode : StopCode.VectorDone);
            return false;
        }

        Underruns += IsDry ? 0 : 1;
        IsDry = true;
        Profile.SetAtRest();
        return false;
    }

    private void PassJoint(VectorSegment segment)
    {
        segment.PointAt(segment.Length, _point);
        for (var i = 0; i < _axes.Length; i++) _joint[i] = Scaled(i);
        Tangent.Follow(segment.TangentAt(segment.Length));
    }

    private void EndAtPresentPlace(int code)
    {
        MoveAxes();
        End(code);
    }

    private void MoveAxes() => PlaceAt(Profile.Travelled);

    private void PlaceAt(double travelled)
    {
        if (Buffer.Current is { } segment)
        {
            segment.PointAt(travelled - segment.StartLength, _point);
            if (Tangent.Axis is not null) Tangent.Follow(segment.TangentAt(travelled - segment.StartLength));
        }

        for (var i = 0; i < _axes.Length; i++) _axes[i].SetPosition(_origin[i] + Scaled(i));
    }

    private void End(int code)
    {
        IsRunning = false;
        Profile.IsStopping = false;
        IsDry = false;
        Profile.SetAtRest();
        Buffer.Abandon();
        foreach (var axis in _axes) axis.LastStop = (int)axis.Position;
        MarkAxes(code);
    }

    private void MarkAxes(int code)
    {
        foreach (var axis in _axes) axis.StopCode = code;
    }

    /// <summary>A position on the path, rounded to whole counts.</summary>
    public static int Rounded(double place) => (int)Math.Round(place, MidpointRounding.AwayFromZero);

    private int Scaled(int slot) => Rounded(_point[slot] * (slot == 0 ? _firstScale : slot == 1 ? _secondScale : 1));
}
