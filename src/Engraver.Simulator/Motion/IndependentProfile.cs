namespace Engraver.Simulator.Motion;

/// <summary>Speed and distance of one axis in an independent move, sample by sample (galil-dmc.md C): to a position, at a speed, or as a homing run
/// requires.</summary>
internal sealed class IndependentProfile(Axis axis)
{
    private double _speed;
    private double _steadyFrom;
    private double _steadyPlace;
    private long _steadySamples;
    private bool _isSteady;

    /// <summary>Position at which the move ends; not used in a jog or a homing move.</summary>
    public double Target { get; set; }

    /// <summary>1 or -1.</summary>
    public int Direction { get; private set; } = 1;

    /// <summary>Signed commanded speed in counts/s.</summary>
    public double Velocity => _speed * Direction;

    public bool IsAtSpeed => _speed == Commanded;

    /// <summary>The axis brakes for the end of its move.</summary>
    public bool IsEnding { get; private set; }

    private double Commanded => axis.IsStopping ? 0 : axis.Homing?.Speed ?? (axis.CurrentMove == AxisMove.Jog ? Math.Abs(axis.JogSpeed) : axis.CruiseSpeed);

    /// <summary>Starts a move from a standstill.</summary>
    /// <param name="direction">1 or -1; 0 counts as 1.</param>
    public void Begin(double target, int direction)
    {
        Target = target;
        Direction = direction == 0 ? 1 : direction;
        _isSteady = false;
        _speed = 0;
    }

    public void Rest()
    {
        _isSteady = false;
        _speed = 0;
        IsEnding = false;
    }

    /// <summary>Computes one sample.</summary>
    /// <returns>The stop code when the move ended in it; null while it continues.</returns>
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

        Go(distance, Math.Max(0, next));
        return null;
    }

    /// <summary>Number of samples for which the speed stays constant and the move does not end; 0 when the next sample must be stepped.</summary>
    public long SteadySamples(long atMost)
    {
        const double FarthestPlace = 2e9;
        if (_speed <= 0 || _speed != Commanded || IsEnding || axis.IsStopping || axis.Homing is not null) return 0;
        var step = _speed * Ramp.Sample;
        if (axis.CurrentMove == AxisMove.Jog) return Math.Sign(axis.JogSpeed) == Direction ? Samples(FarthestPlace - Math.Abs(axis.Position)) : 0;
        if (axis.CurrentMove is not (AxisMove.Relative or AxisMove.Absolute)) return 0;
        var remaining = (Target - axis.Position) * Direction;
        var samples = Samples(remaining - (_speed * _speed / (2 * axis.Deceleration)));
        while (samples > 0 && Ramp.Braking(_speed, remaining - ((samples - 1) * step), 0, axis.Deceleration, Ramp.Sample) < _speed) samples /= 2;
        return samples;

        long Samples(double length) => Math.Min(atMost, (long)Math.Max(0, (length / step) - 3));
    }

    /// <summary>Position after the given number of samples at constant speed.</summary>
    public double PlaceAfter(long samples)
    {
        StartSteady();
        return _steadyPlace = SteadyPlace(samples);
    }

    /// <summary>Advances by the given number of <see cref="SteadySamples"/>; the position is equal to that of single steps to the last bit.</summary>
    public void PassSteady(long samples)
    {
        StartSteady();
        _steadyPlace = SteadyPlace(samples);
        _steadySamples += samples;
        axis.SetPosition(_steadyPlace);
    }

    public AxisCourse Course()
    {
        StartSteady();
        return new AxisCourse(axis.Index, _steadyFrom, Direction * (_speed * Ramp.Sample), _steadySamples);
    }

    private double SteadyPlace(long samples) => _steadyFrom + ((_steadySamples + samples) * (Direction * (_speed * Ramp.Sample)));

    /// <summary>Stores the start of constant speed: distances are then a number of samples times the distance of one sample, so that rounding does not
    /// accumulate. Restarts when a command has changed the position.</summary>
    private void StartSteady()
    {
        if (_isSteady && axis.Position == _steadyPlace) return;
        (_steadyFrom, _steadySamples, _steadyPlace, _isSteady) = (axis.Position, 0, axis.Position, true);
    }

    private void Go(double distance, double next)
    {
        if (next == _speed && next > 0)
        {
            PassSteady(1);
            return;
        }

        _isSteady = false;
        _speed = next;
        axis.SetPosition(axis.Position + (Direction * distance));
    }

    /// <summary>A tracked target (PT) has already been passed, or is too close to stop before it.</summary>
    private bool MustTurn() =>
        _speed > 0 && (Target - axis.Position) * Direction < (_speed * _speed / (2 * axis.Deceleration)) - (_speed * Ramp.Sample);

    private int? StepFree()
    {
        // A jog that changes its sign first brakes to zero and then reverses.
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
        return homing.Advance(axis, ref _speed);
    }

    private void Roll(double commanded)
    {
        var next = Ramp.Towards(_speed, commanded, axis.Acceleration, axis.Deceleration, Ramp.Sample);
        Go((_speed + next) / 2 * Ramp.Sample, next);
    }
}
