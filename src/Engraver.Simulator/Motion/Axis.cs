using Engraver.Simulator.Language;

namespace Engraver.Simulator.Motion;

/// <summary>One axis with its independent profiler (galil-dmc.md C). Positions in counts; the motor follows without error (I.14).</summary>
internal sealed class Axis(int index)
{
    public const string Letters = "ABCDNM";
    public const int Real = 4;

    private double _target;
    private double _speed;
    private int _direction = 1;

    /// <summary>0 to 3 are A to D, 4 and 5 the virtual axes N and M.</summary>
    public int Index => index;

    public char Letter => Letters[index];

    /// <summary>Commanded position before rounding.</summary>
    public double Position { get; private set; }

    /// <summary>Commanded position as the controller reports it (RP).</summary>
    public int Reference => (int)Math.Round(Position, MidpointRounding.AwayFromZero);

    public double CruiseSpeed { get; set; } = 25000;

    public double Acceleration { get; set; } = 256000;

    public double Deceleration { get; set; } = 256000;

    public double JogSpeed { get; set; } = 25000;

    public int AbsoluteTarget { get; set; }

    public int RelativeDistance { get; set; }

    public AxisMove NextMove { get; set; } = AxisMove.Relative;

    public AxisMove CurrentMove { get; private set; } = AxisMove.Relative;

    public bool IsMoving { get; private set; }

    public bool IsStopping { get; private set; }

    /// <summary>Where the running or last independent move began.</summary>
    public double MoveStart { get; private set; }

    /// <summary>Where the last motion stopped: what PA reports (galil-dmc.md C).</summary>
    public int LastStop { get; set; }

    public int StopCode { get; set; } = Motion.StopCode.AtTarget;

    public bool MotorOff { get; set; }

    public FixedPoint MotorType { get; set; } = FixedPoint.True;

    public int OffOnError { get; set; }

    public int ForwardSoftLimit { get; set; } = int.MaxValue;

    public int ReverseSoftLimit { get; set; } = int.MinValue;

    /// <summary>Limit switch hit; the test sets it.</summary>
    public bool ForwardSwitch { get; set; }

    public bool ReverseSwitch { get; set; }

    /// <summary>Stored settings without an effect on the perfect motor: KP, KD, ER and the like.</summary>
    public Dictionary<string, FixedPoint> Settings { get; } = [];

    public bool IsStepper => Math.Abs(MotorType.Value) >= 2;

    /// <summary>Signed commanded speed of the independent move in counts/s.</summary>
    public double Velocity => _speed * _direction;

    public bool IsAtSpeed => IsMoving && _speed == Commanded;

    private double Commanded => IsStopping ? 0 : CurrentMove == AxisMove.Jog ? Math.Abs(JogSpeed) : CruiseSpeed;

    public void SetPosition(double position) => Position = position;

    /// <summary>The move as BG would make it: its end for PA and PR, null for a jog.</summary>
    public long? PendingTarget() => NextMove switch
    {
        AxisMove.Absolute => AbsoluteTarget,
        AxisMove.Relative => (long)Reference + RelativeDistance,
        _ => null,
    };

    public void Begin()
    {
        CurrentMove = NextMove;
        _target = PendingTarget() ?? 0;
        _direction = CurrentMove == AxisMove.Jog ? Math.Sign(JogSpeed) : Math.Sign(_target - Position);
        _direction = _direction == 0 ? 1 : _direction;
        MoveStart = Position;
        _speed = 0;
        IsMoving = true;
        IsStopping = false;
        StopCode = Motion.StopCode.Running;
    }

    public void Stop(int stopCode)
    {
        if (IsMoving && !IsStopping)
        {
            IsStopping = true;
            StopCode = stopCode;
        }
    }

    /// <summary>Stands still at once, without a ramp (AB).</summary>
    public void Halt(int stopCode)
    {
        if (IsMoving)
        {
            StopCode = stopCode;
            End();
        }
    }

    /// <summary>One sample; false when the move ended in it.</summary>
    public bool Step()
    {
        if (CurrentMove == AxisMove.Jog || IsStopping) return StepFree();

        var remaining = Math.Abs(_target - Position);
        var next = Math.Min(
            Ramp.Towards(_speed, Commanded, Acceleration, Deceleration, Ramp.Sample),
            Math.Max(_speed - (Deceleration * Ramp.Sample), Ramp.Braking(_speed, remaining, 0, Deceleration, Ramp.Sample)));
        var distance = (_speed + Math.Max(0, next)) / 2 * Ramp.Sample;
        if (distance >= remaining - 1e-6 || (next <= 0 && remaining < 0.5))
        {
            Position = _target;
            StopCode = Motion.StopCode.AtTarget;
            End();
            return false;
        }

        _speed = Math.Max(0, next);
        Position += _direction * distance;
        return true;
    }

    /// <summary>True when the axis moves towards a limit switch or has reached a software limit.</summary>
    public bool RunsIntoLimit(double velocity, out int stopCode)
    {
        stopCode = velocity > 0 ? Motion.StopCode.ForwardLimit : Motion.StopCode.ReverseLimit;
        return (velocity > 0 && (ForwardSwitch || (ForwardSoftLimit != int.MaxValue && Reference >= ForwardSoftLimit)))
            || (velocity < 0 && (ReverseSwitch || (ReverseSoftLimit != int.MinValue && Reference <= ReverseSoftLimit)));
    }

    private bool StepFree()
    {
        // A jog that changes its sign brakes to zero first and then turns round.
        var turning = !IsStopping && Math.Sign(JogSpeed) == -_direction && JogSpeed != 0;
        var next = Ramp.Towards(_speed, turning ? 0 : Commanded, Acceleration, Deceleration, Ramp.Sample);
        Position += _direction * (_speed + next) / 2 * Ramp.Sample;
        _speed = next;
        if (_speed == 0 && turning) _direction = -_direction;

        if (_speed > 0 || !IsStopping) return true;

        Position = Reference;
        End();
        return false;
    }

    private void End()
    {
        Position = Reference;
        LastStop = Reference;
        _speed = 0;
        IsMoving = false;
        IsStopping = false;
    }
}
