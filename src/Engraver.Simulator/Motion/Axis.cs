using Engraver.Simulator.Motion.Following;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Motion;

/// <summary>One axis with its independent profiler (galil-dmc.md C). Positions in counts.</summary>
internal sealed class Axis
{
    public const string Letters = "ABCDNM";
    public const int Real = 4;

    /// <summary>Bit of CE that reverses the main encoder (galil-dmc.md C).</summary>
    private const int ReversedEncoder = 2;

    private readonly IndependentProfile _profile;
    private readonly bool _isWiredReversed;
    private double _smoothed;

    /// <param name="index">0 to 3 are A to D, 4 and 5 the virtual axes N and M.</param>
    public Axis(int index, InputPolarity polarity, SimulatorOptions options)
    {
        Index = index;
        _isWiredReversed = options.ReversedWiring.Contains(Letters[index], StringComparison.Ordinal);
        Inputs = new AxisInputs(polarity, options.Switches.FirstOrDefault(s => s.Axis == index));
        Motor = new Motor(index < Real ? options.ServoLag : TimeSpan.Zero);
        _profile = new IndependentProfile(this);
    }

    public int Index { get; }

    public char Letter => Letters[Index];

    public AxisInputs Inputs { get; }

    public Motor Motor { get; }

    public Gear Gear { get; } = new();

    public Latch Latch { get; } = new();

    /// <summary>Commanded position before smoothing and rounding.</summary>
    public double Position { get; private set; }

    /// <summary>Commanded position as the controller reports it (RP).</summary>
    public int Reference => (int)Math.Round(_smoothed, MidpointRounding.AwayFromZero);

    /// <summary>Counts that DP, homing and power cycles have added to the number of a physical position since the first power up.</summary>
    public double Shift { get; private set; }

    /// <summary>TP: the main encoder; for a stepper, which has no encoder in its loop, the commanded position.</summary>
    public int Encoder => IsStepper ? Reference : Motor.Counts;

    /// <summary>For the record: the physical motor position, independent of the commanded position.</summary>
    public int Place => Motor.Counts;

    /// <summary>TD: the auxiliary encoder, for a stepper the pulses sent.</summary>
    public int SecondEncoder => IsStepper ? Reference : Auxiliary;

    /// <summary>RP - TP: <c>_TE</c>, limited to the 32-bit range; 0 for a stepper.</summary>
    public int Error => IsStepper ? 0 : (int)Math.Clamp((long)Reference - Motor.Counts, -int.MaxValue, int.MaxValue);

    /// <summary>The register that DE sets: the auxiliary encoder of a servo, the main encoder of a stepper.</summary>
    public int Auxiliary { get; set; }

    public double CruiseSpeed { get; set; } = 25000;

    public double Acceleration { get; set; } = 256000;

    public double Deceleration { get; set; } = 256000;

    public double JogSpeed { get; set; } = 25000;

    public int AbsoluteTarget { get; set; }

    public int RelativeDistance { get; set; }

    public AxisMove NextMove { get; set; } = AxisMove.Relative;

    public AxisMove CurrentMove { get; private set; } = AxisMove.Relative;

    /// <summary>PT 1: every PA starts a move at once.</summary>
    public bool IsTracking { get; set; }

    /// <summary>Fraction of the distance to the profile that one sample covers: IT in independent moves, VT in vector moves; 1 means no smoothing.</summary>
    public double Smoothing { get; set; } = 1;

    public bool IsMoving { get; private set; }

    public bool IsStopping { get; private set; }

    /// <summary>The axis brakes for the end of its move: bit "final deceleration" of the status word (A.9).</summary>
    public bool IsEnding => _profile.IsEnding;

    /// <summary>The profile has ended but its smoothed output has not reached it.</summary>
    public bool IsSmoothing => !IsMoving && Math.Abs(Position - _smoothed) >= 0.5;

    /// <summary>The next sample will still change a position although no profile runs.</summary>
    public bool IsSettling => IsSmoothing || (IsLoopReversed && Motor.WillRunOn(_smoothed, MotorOff)) || (!IsStepper && !IsLoopReversed && Motor.IsSettling(_smoothed, MotorOff));

    /// <summary>A homing move in progress; null otherwise.</summary>
    public HomingRun? Homing { get; private set; }

    /// <summary>Position at which the running or last independent move started.</summary>
    public double MoveStart { get; private set; }

    /// <summary>Position from which the next AR counts: that of the start of the move, or that of the previous AR.</summary>
    public double TrippointReference { get; set; }

    /// <summary>Position at which the last motion stopped, which PA reports (galil-dmc.md C).</summary>
    public int LastStop { get; set; }

    public int StopCode { get; set; } = Motion.StopCode.AtTarget;

    public bool MotorOff { get; set; }

    public FixedPoint MotorType { get; set; } = FixedPoint.True;

    public int OffOnError { get; set; }

    /// <summary>ER: a position error beyond this many counts is a fault; 0 and -1 switch the check off.</summary>
    public double ErrorLimit { get; set; } = 16384;

    public int ForwardSoftLimit { get; set; } = int.MaxValue;

    public int ReverseSoftLimit { get; set; } = int.MinValue;

    /// <summary>Settings that are stored and read back: KP, KD, ER etc.</summary>
    public Dictionary<string, FixedPoint> Settings { get; } = [];

    /// <summary>The loop of a servo corrects in the wrong direction: an odd number of its wiring, motor type and encoder type are reversed (galil-dmc.md C,
    /// MT and CE).</summary>
    public bool IsLoopReversed => !IsStepper && (_isWiredReversed ^ (MotorType.Value < 0) ^ (Settings.Count > 0 && ((int)Setting("CE", 0) & ReversedEncoder) != 0));

    public bool IsStepper => Math.Abs(MotorType.Value) >= 2;

    /// <summary>Signed commanded speed of the independent move in counts/s.</summary>
    public double Velocity => _profile.Velocity;

    public bool IsAtSpeed => IsMoving && _profile.IsAtSpeed;

    public double Setting(string mnemonic, double atStart) => Settings.TryGetValue(mnemonic, out var value) ? value.Value : atStart;

    public void SetPosition(double position)
    {
        Position = position;
        if (Smoothing >= 1) _smoothed = position;
    }

    /// <summary>Redefines the position without moving the axis: DP, or the zero at the end of a homing move.</summary>
    public void Redefine(double position)
    {
        Shift += position - Motor.Position; // the motor keeps its physical position, even where it could not follow
        Position = position;
        _smoothed = position;
        LastStop = Reference;
        Motor.Define(position);
    }

    /// <summary>Shifts the position value without moving the axis, even in motion: the electronic cam counts positions within a cycle (C.4).</summary>
    public void Renumber(double difference)
    {
        Shift += difference;
        Position += difference;
        _smoothed += difference;
        _profile.Target += difference;
        MoveStart += difference;
        TrippointReference += difference;
        Motor.Renumber(difference);
    }

    /// <summary>SH: the motor position becomes the commanded position (C); the motor position of a stepper is unknown.</summary>
    public void TakeMotorPosition() => SetPosition(_smoothed = Encoder);

    /// <summary>Target of the move that BG would start: for PA and PR; null for a jog or a homing move.</summary>
    public long? PendingTarget() => NextMove switch
    {
        AxisMove.Absolute or AxisMove.Tracking => AbsoluteTarget,
        AxisMove.Relative => (long)Reference + RelativeDistance,
        _ => null,
    };

    /// <summary>Direction of the move that BG would start: 1, -1, or 0 when its target is the present position.</summary>
    public double PendingHeading() =>
        PendingTarget() is { } target ? target - (long)Reference : NextMove == AxisMove.Jog ? JogSpeed : HomingRun.Heading(this, NextMove);

    public void Begin()
    {
        CurrentMove = NextMove;
        Homing = CurrentMove is AxisMove.Home or AxisMove.FindEdge or AxisMove.FindIndex ? new HomingRun(this, CurrentMove) : null;
        if (Homing is not null) NextMove = AxisMove.Relative;
        double target = PendingTarget() ?? 0;
        _profile.Begin(target, Homing?.Direction ?? (CurrentMove == AxisMove.Jog ? Math.Sign(JogSpeed) : Math.Sign(target - Position)));
        Smoothing = Setting("IT", 1);
        MoveStart = Position;
        TrippointReference = Position;
        IsMoving = true;
        IsStopping = false;
        StopCode = Motion.StopCode.Running;
    }

    /// <summary>PA under PT: the running move gets a new target, or a move starts.</summary>
    public void Track(int target)
    {
        AbsoluteTarget = target;
        NextMove = AxisMove.Tracking;
        if (!IsMoving) Begin();
        _profile.Target = target;
    }

    /// <summary>IP in motion: a jog jumps by these counts, a move gets a more distant target (C).</summary>
    /// <exception cref="CommandRefusedException">TC 16: against the direction of the move, or the axis is already stopping.</exception>
    public void Extend(int counts)
    {
        if (IsStopping || (CurrentMove != AxisMove.Jog && Math.Sign(counts) != _profile.Direction)) throw new CommandRefusedException(Tc.WrongSignOfIncrement);
        if (CurrentMove == AxisMove.Jog) SetPosition(Position + counts);
        else _profile.Target += counts;
    }

    public void Stop(int stopCode)
    {
        IsTracking &= stopCode != Motion.StopCode.Stopped;
        if (!IsMoving || IsStopping) return;
        IsStopping = true;
        StopCode = stopCode;
    }

    /// <summary>Stops at once, without a ramp (AB).</summary>
    public void Halt(int stopCode)
    {
        if (!IsMoving) return;
        StopCode = stopCode;
        End();
    }

    /// <summary>Computes one sample; returns false when the move ended in it.</summary>
    public bool Step()
    {
        if (_profile.Step() is not { } code) return true;
        StopCode = code;
        End();
        return false;
    }

    /// <summary>Number of samples for which its independent move continues at constant speed.</summary>
    public long SteadySamples(long atMost) => _profile.SteadySamples(atMost);

    /// <summary>Sets the position to its value after the given number of samples at constant speed; the profile does not advance.</summary>
    public void PlaceSteady(long samples) => SetPosition(_profile.PlaceAfter(samples));

    public void PassSteady(long samples) => _profile.PassSteady(samples);

    /// <summary>The positions of the axis from now on at constant speed.</summary>
    public AxisCourse Course() => _profile.Course();

    /// <summary>Only the profile determines the position: no smoothing, no lag, no blocked or disabled motor, no switch that it could pass, no latch that waits
    /// for an index.</summary>
    public bool IsPlain => Smoothing >= 1 && !MotorOff && !IsLoopReversed && Motor.IsPlain && !Inputs.HasSwitches && Latch is not { IsArmed: true, WaitsForIndex: true };

    /// <summary>Operates the switches by the commanded position: in a homing move they do not depend on the motor, which lags behind.</summary>
    public void PassSwitches() => Inputs.MoveTo(Position - Motor.Lost - Shift);

    /// <summary>Called after every sample: the smoothed output and the motor follow the profile.</summary>
    public void Follow()
    {
        _smoothed = Smoothing >= 1 ? Position : _smoothed + ((Position - _smoothed) * Smoothing);
        if (!IsMoving && Math.Abs(Position - _smoothed) < 0.5) _smoothed = Position;
        if (IsStepper) Motor.Step(_smoothed);
        else if (IsLoopReversed) Motor.RunAway(_smoothed, MotorOff);
        else Motor.Follow(_smoothed, MotorOff);
        Inputs.MoveTo(Motor.Position - Shift);
    }

    /// <summary>True when the axis moves towards an active limit switch or has reached a software limit.</summary>
    public bool RunsIntoLimit(double velocity, out int stopCode)
    {
        stopCode = velocity > 0 ? Motion.StopCode.ForwardLimit : Motion.StopCode.ReverseLimit;
        return (velocity > 0 && (Inputs.ForwardHit || (ForwardSoftLimit != int.MaxValue && Reference >= ForwardSoftLimit)))
            || (velocity < 0 && (Inputs.ReverseHit || (ReverseSoftLimit != int.MinValue && Reference <= ReverseSoftLimit)));
    }

    private void End()
    {
        SetPosition(Math.Round(Position, MidpointRounding.AwayFromZero));
        LastStop = (int)Position;
        _profile.Rest();
        IsMoving = false;
        IsStopping = false;
        Homing = null;
    }
}
