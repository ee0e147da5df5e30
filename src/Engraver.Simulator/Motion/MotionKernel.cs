using Engraver.Simulator.Motion.Following;

namespace Engraver.Simulator.Motion;

/// <summary>All axes and both planes, one sample at a time (galil-dmc.md I.9 to I.11).</summary>
internal sealed class MotionKernel
{
    /// <summary>Counts that each axis moved along a vector path in the last sample.</summary>
    private readonly int[] _sampleSteps = new int[Axis.Letters.Length];
    private readonly bool[] _isBeyondError = new bool[Axis.Real];
    private int _limitHits;
    private int _errorHits;
    private bool _isUnsettled;
    private SteadyMotion? _steady;

    public MotionKernel(SimulatorOptions options)
    {
        Axes = [.. Enumerable.Range(0, Axis.Letters.Length).Select(i => new Axis(i, Polarity, options))];
        Planes = [new VectorPlane('S', options), new VectorPlane('T', options)];
        Selected = Planes[0];
        Contour = new ContourMode(options.ContourRecords);
        Cam = new ElectronicCam(this);
    }

    public InputPolarity Polarity { get; } = new();

    public Axis[] Axes { get; }

    /// <summary>The planes S and T.</summary>
    public VectorPlane[] Planes { get; }

    /// <summary>Contour mode (CM, DT, CD).</summary>
    public ContourMode Contour { get; }

    /// <summary>The electronic cam (EA to EQ).</summary>
    public ElectronicCam Cam { get; }

    /// <summary>The plane that CA selected.</summary>
    public VectorPlane Selected { get; set; }

    /// <summary>Vector segments executed since power up, in both planes.</summary>
    public long SegmentsExecuted => Planes[0].Profile.SegmentsExecuted + Planes[1].Profile.SegmentsExecuted;

    /// <summary>Number of moves and sequences that have ended.</summary>
    public long Ends { get; private set; }

    /// <summary>An axis follows a source other than its own profile, or a change by a command has not reached the motors yet.</summary>
    public bool HasFollowers => _isUnsettled || Contour.CanProgress || Cam.IsEnabled || Array.Exists(Axes, static axis => axis.Gear.IsEngaged || axis.IsSettling);

    /// <summary>True when the next sample will change a position or end a motion.</summary>
    public bool CanProgress
    {
        get
        {
            if (_isUnsettled || Contour.CanProgress) return true;
            foreach (var axis in Axes)
            {
                if (axis.IsMoving || axis.IsSettling) return true;
            }

            return Planes[0].CanProgress || Planes[1].CanProgress;
        }
    }

    /// <summary>Computes one sample of all axes and planes; returns true when an axis moved.</summary>
    public bool Step()
    {
        var moved = false;
        var geared = false;
        Array.Clear(_sampleSteps);
        foreach (var plane in Planes) moved |= plane.IsRunning && StepPlane(plane);
        foreach (var axis in Axes) moved |= axis.IsMoving && StepAxis(axis);
        if (Contour.CanProgress) moved |= StepContour();
        if (Cam.IsEnabled) moved |= StepCam();
        foreach (var axis in Axes)
        {
            geared |= axis.Gear.IsEngaged;
            moved |= Follow(axis);
        }

        _isUnsettled = (Cam.IsEnabled && Cam.IsBehind) || (geared && Array.Exists(Axes, IsBehindMaster));
        return moved;
    }

    /// <summary>Computes samples of constant speed in one jump.</summary>
    public SteadyMotion Steady => _steady ??= new SteadyMotion(this);

    /// <summary>Called after a jump: updates the motors and the switches.</summary>
    public void FollowAll()
    {
        foreach (var axis in Axes) axis.Follow();
    }

    /// <summary>Called when a command has changed a position: the next sample transfers it to the motors.</summary>
    public void Unsettle() => _isUnsettled = true;

    public bool IsCoordinated(Axis axis) => PlaneOf(axis) is not null;

    /// <summary>The running plane that drives an axis.</summary>
    public VectorPlane? PlaneOf(Axis axis) => Planes[0].Drives(axis) ? Planes[0] : Planes[1].Drives(axis) ? Planes[1] : null;

    public bool IsBusy(Axis axis) => axis.IsMoving || axis.IsSmoothing || IsCoordinated(axis) || (Contour.CanProgress && Contour.Drives(axis));

    /// <summary>The axis is a slave of the running cam.</summary>
    public bool IsOnCam(Axis axis) => axis.Index < Axis.Real && Cam.Followers[axis.Index].IsEngaged;

    /// <summary>Shifts the position value of an axis; all motion that drives it or follows it continues.</summary>
    public void Renumber(Axis axis, double difference)
    {
        axis.Renumber(difference);
        foreach (var plane in Planes) plane.Renumber(axis, difference);
        foreach (var other in Axes)
        {
            if (other.Gear.Master is not ('S' or 'T') && AxisSelection.IndexOf(other.Gear.Master) == axis.Index) other.Gear.Renumber(difference);
        }
    }

    /// <summary>Signed commanded speed of an axis in counts/s; along a vector path from the last sample.</summary>
    public double VelocityOf(Axis axis) =>
        axis.IsMoving ? axis.Velocity
        : PlaneOf(axis) is { Profile.Speed: > 0 } || (IsLed(axis) && CanProgress) ? _sampleSteps[axis.Index] / Ramp.Sample
        : 0;

    /// <summary>Position of a gear's master: the path length of a plane, or the position of an axis (B.6).</summary>
    public double PlaceOfMaster(char master) =>
        master is 'S' or 'T' ? Planes[master - 'S'].Profile.Odometer
        : AxisSelection.IndexOf(master) is >= 0 and var index ? Axes[index].Motor.Position
        : 0;

    /// <summary>Limits hit since the last call.</summary>
    public int TakeLimitHits()
    {
        var hits = _limitHits;
        _limitHits = 0;
        return hits;
    }

    /// <summary>Position errors that grew beyond ER since the last call.</summary>
    public int TakeErrorHits()
    {
        var hits = _errorHits;
        _errorHits = 0;
        return hits;
    }

    /// <summary>Stops an axis at once, with the plane or contour that moves it; its motor is switched off if OE requires it (C, OE).</summary>
    public void Halt(Axis axis, int code, bool motorsOff)
    {
        var plane = PlaneOf(axis);
        ReadOnlySpan<Axis> all = plane is null ? [axis] : plane.Axes;
        foreach (var other in all) other.MotorOff |= motorsOff;
        plane?.Halt(code);
        axis.Halt(code);
        if (axis.Index < Axis.Real) Cam.Followers[axis.Index].Release(code);
        if (!Contour.Drives(axis)) return;
        foreach (var other in Contour.Axes) other.MotorOff |= motorsOff;
        Contour.End(code);
    }

    /// <summary>ST: ends gear, cam and contour motion of the axis; cam and contour stop at once.</summary>
    public void ReleaseAxis(Axis axis, int code)
    {
        axis.Gear.Release();
        if (axis.Index < Axis.Real) Cam.Followers[axis.Index].Release(code);
        if (Contour.Drives(axis)) Contour.End(code);
    }

    private bool IsLed(Axis axis) => axis.Gear.IsEngaged || IsOnCam(axis) || Contour.Drives(axis);

    private bool IsBehindMaster(Axis axis) => axis.Gear.IsEngaged && axis.Gear.IsBehind(PlaceOfMaster(axis.Gear.Master));

    private bool StepContour()
    {
        Span<int> before = stackalloc int[Axis.Letters.Length];
        var axes = Contour.Axes;
        for (var i = 0; i < axes.Length; i++) before[i] = axes[i].Reference;
        Contour.Step();
        Ends += Contour.IsOn ? 0 : 1;
        for (var i = 0; i < axes.Length; i++)
        {
            var axis = axes[i];
            var step = axis.Reference - before[i];
            _sampleSteps[axis.Index] = step;
            if (Contour.IsOn && step != 0 && axis.RunsIntoLimit(step, out var code)) HitLimit(axis, code, null);
        }

        return true;
    }

    private bool StepCam()
    {
        var moved = false;
        _limitHits += Cam.Step();
        foreach (var follower in Cam.Followers)
        {
            if (follower.LastStep == 0) continue;
            _sampleSteps[follower.Axis.Index] = follower.LastStep;
            moved = true;
        }

        return moved;
    }

    private bool StepPlane(VectorPlane plane)
    {
        Span<int> before = stackalloc int[Axis.Letters.Length];
        for (var i = 0; i < plane.Axes.Length; i++) before[i] = plane.Axes[i].Reference;
        var moved = plane.Step();
        Ends += plane.IsRunning ? 0 : 1;
        for (var i = 0; i < plane.Axes.Length; i++)
        {
            var axis = plane.Axes[i];
            var step = (int)Math.Round(axis.Position, MidpointRounding.AwayFromZero) - before[i];
            _sampleSteps[axis.Index] = plane.IsRunning ? step : 0;
            if (plane is { IsRunning: true, Profile.IsStopping: false } && axis.RunsIntoLimit(step, out var code)) HitLimit(axis, code, plane);
        }

        return moved;
    }

    private bool StepAxis(Axis axis)
    {
        Ends += axis.Step() ? 0 : 1;
        if (axis.IsMoving && !axis.IsStopping && axis.RunsIntoLimit(axis.Velocity, out var code)) HitLimit(axis, code, null);
        return true;
    }

    /// <summary>Brakes as ST does; with OE 2 or 3 the motor is switched off instead (C.1).</summary>
    private void HitLimit(Axis axis, int code, VectorPlane? plane)
    {
        _limitHits++;
        if (axis.OffOnError >= 2) Halt(axis, code, motorsOff: true);
        else if (plane is not null) plane.Stop(code);
        else if (Contour.Drives(axis)) Contour.End(code);
        else axis.Stop(code);
    }

    private bool Follow(Axis axis)
    {
        var (before, motor) = (axis.Reference, axis.Motor.Counts);
        if (axis.Gear.IsEngaged) FollowGear(axis);
        var settling = axis.IsSmoothing;
        axis.Follow();
        if (axis.Latch is { IsArmed: true, WaitsForIndex: true } && axis.Inputs.IndexPassed is { } away) axis.Latch.Catch(axis.Motor.Position + away);
        if (axis.Index < Axis.Real) CheckError(axis);
        if (settling && !axis.IsSmoothing) Ends++;
        return axis.Reference != before || axis.Motor.Counts != motor;
    }

    private void FollowGear(Axis axis)
    {
        var counts = axis.Gear.Follow(PlaceOfMaster(axis.Gear.Master));
        if (counts == 0) return;
        if (axis.RunsIntoLimit(counts, out var code))
        {
            _limitHits++;
            axis.StopCode = code;
            axis.Gear.Release();
            return;
        }

        _sampleSteps[axis.Index] = (int)Math.Round(counts);
        axis.SetPosition(Math.Clamp(axis.Position + counts, int.MinValue, int.MaxValue)); // limited, because gears that drive each other would run to infinity
    }

    /// <summary>Counts a position error beyond ER once until it has been smaller again; with OE 1 or 3 all motion that drives the axis stops and its motors are
    /// switched off (C, ER, OE).</summary>
    private void CheckError(Axis axis)
    {
        var beyond = !axis.MotorOff && axis.ErrorLimit > 0 && Math.Abs(axis.Error) > axis.ErrorLimit;
        if (beyond && !_isBeyondError[axis.Index])
        {
            _errorHits++;
            if (axis.OffOnError is 1 or 3) Halt(axis, StopCode.OffOnError, motorsOff: true);
        }

        _isBeyondError[axis.Index] = beyond;
    }
}
