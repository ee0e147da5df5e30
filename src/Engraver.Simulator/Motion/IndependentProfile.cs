namespace Engraver.Simulator.Motion;

/// <summary>Speed and way of one axis in an independent move, sample by sample (galil-dmc.md C): to a place, at a speed, or as a homing run wants it.</summary>
internal sealed class IndependentProfile(Axis axis)
{
    private double _speed;

    /// <summary>Where the move ends; without meaning for a jog or a homing.</summary>
    public double Target { get; set; }

    /// <summary>1 or -1.</summary>
    public int Direction { get; private set; } = 1;

    /// <summary>Signed commanded speed in counts/s.</summary>
    public double Velocity => _speed * Direction;

    public bool IsAtSpeed => _speed == Commanded;

    /// <summary>It brakes for the end of its move.</summary>
    public bool IsEnding { get; private set; }

    private double Commanded => axis.IsStopping ? 0 : axis.Homing?.Speed ?? (axis.CurrentMove == AxisMove.Jog ? Math.Abs(axis.JogSpeed) : axis.CruiseSpeed);

    /// <summary>From a standstill.</summary>
    /// <param name="direction">Sense of the move; 0 counts as forwards.</param>
    public void Begin(double target, int direction)
    {
        Target = target;
        Direction = direction == 0 ? 1 : direction;
        _speed = 0;
    }

    public void Rest()
    {
        _speed = 0;
        IsEnding = false;
    }

    /// <summary>One sample.</summary>
    /// <returns>The stop code when the move ended in it; null while it goes on.</returns>
    public int? Step() =>
        axis.IsStopping || axis.CurrentMove == AxisMove.Jog ? StepFree()
        : axis.Homing is { } homing ? StepHoming(homing)
        : axis.CurrentMove == AxisMove.Tracking && MustTurn() ? StepFree()
        : StepToTarget();

    private int? StepToTarget()
    {
        if (_speed == 0 && axis.CurrentMove == AxisMove.Tracking) Direction = Math.Sign(Target - axis.Position) is var sign && sign != 0 ? sign : Direction;
        var remaining = Math.Abs(Target - axis.Position);
        var towards = Ramp.Towards(_speed, Commanded, axis.Acceleration, axis.Deceleration, Ramp.Sample);
        var braking = Math.Max(_speed - (axis.Deceleration * Ramp.Sample), Ramp.Braking(_speed, remaining, 0, axis.Deceleration, Ramp.Sample));
        var next = Math.Min(towards, braking);
        IsEnding = braking < towards;
        var distance = (_speed + Math.Max(0, next)) / 2 * Ramp.Sample;
        if (distance >= remaining - 1e-6 || (next <= 0 && remaining < 0.5))
        {
            axis.SetPosition(Target);
            return StopCode.AtTarget;
        }

        _speed = Math.Max(0, next);
        axis.SetPosition(axis.Position + (Direction * distance));
        return null;
    }

    /// <summary>A tracked target lies behind, or too near to stop in front of it.</summary>
    private bool MustTurn() =>
        _speed > 0 && (Target - axis.Position) * Direction < (_speed * _speed / (2 * axis.Deceleration)) - (_speed * Ramp.Sample);

    private int? StepFree()
    {
        // A jog that changes its sign brakes to zero first and then turns round.
        var turning = !axis.IsStopping && (axis.CurrentMove == AxisMove.Tracking || (Math.Sign(axis.JogSpeed) == -Direction && axis.JogSpeed != 0));
        Roll(turning ? 0 : Commanded);
        if (_speed == 0 && turning) Direction = -Direction;
        return _speed > 0 || !axis.IsStopping ? null : axis.StopCode;
    }

    private int? StepHoming(HomingRun homing)
    {
        Direction = homing.Direction;
        Roll(homing.Speed);
        axis.PassSwitches();
        return homing.Look(axis, ref _speed);
    }

    private void Roll(double commanded)
    {
        var next = Ramp.Towards(_speed, commanded, axis.Acceleration, axis.Deceleration, Ramp.Sample);
        axis.SetPosition(axis.Position + (Direction * (_speed + next) / 2 * Ramp.Sample));
        _speed = next;
    }
}
