namespace Engraver.Simulator.Motion;

/// <summary>The motor with its encoder: perfect, or with a first-order lag to the commanded position (galil-dmc.md I.14). A stepper has no encoder in its loop:
/// it makes the steps that are sent to it, and loses those that are sent while its shaft is blocked.</summary>
internal sealed class Motor(TimeSpan lag)
{
    private const double SettledShare = 0.01;

    /// <summary>Fraction of its error by which a motor in a loop of the wrong sign moves further in a sample, and the counts that start this motion.</summary>
    private const double RunawayShare = 0.05;
    private const double RunawayPush = 0.5;

    /// <summary>Counts that such a motor moves in a sample at full speed.</summary>
    private const double RunawayStep = 200.0;

    /// <summary>Error at which the axis has reached its mechanical end, counts.</summary>
    private const double RunawayEnd = 100_000.0;

    private readonly double _share = lag <= TimeSpan.Zero ? 1 : 1 - Math.Exp(-Ramp.Sample / lag.TotalSeconds);

    /// <summary>Encoder position, counts; for a stepper the physical position of its shaft.</summary>
    public double Position { get; private set; }

    /// <summary>The shaft is blocked: the motor does not move and the position error grows.</summary>
    public bool IsHeld { get; set; }

    /// <summary>Steps that were sent to a stepper but not made by its shaft, counts; 0 for a servo.</summary>
    public double Lost { get; private set; }

    /// <summary>The motor is always at its commanded position: no lag, not blocked, no lost steps.</summary>
    public bool IsPlain => _share >= 1 && !IsHeld && Lost == 0;

    public int Counts => (int)Math.Round(Position, MidpointRounding.AwayFromZero);

    /// <summary>Sends a stepper the steps to the commanded position.</summary>
    public void Step(double commanded)
    {
        if (IsHeld) Lost = commanded - Position;
        else Position = commanded - Lost;
    }

    /// <summary>Moves for one sample towards the commanded position; a motor that is off stays where it is.</summary>
    public void Follow(double commanded, bool isOff)
    {
        Lost = 0;
        if (IsHeld || isOff) return;
        Position += (commanded - Position) * _share;
        if (Math.Abs(commanded - Position) < SettledShare) Position = commanded;
    }

    /// <summary>Moves for one sample away from the commanded position: the loop corrects every error in the wrong direction (motor or encoder reversed;
    /// galil-dmc.md C, MT and CE).</summary>
    public void RunAway(double commanded, bool isOff)
    {
        if (!WillRunOn(commanded, isOff)) return;
        var error = Position - commanded;
        Position += Math.CopySign(Math.Min(RunawayStep, (Math.Abs(error) * RunawayShare) + RunawayPush), error);
    }

    /// <summary>A motor in a loop of the wrong sign is still moving.</summary>
    public bool WillRunOn(double commanded, bool isOff) => !IsHeld && !isOff && Math.Abs(Position - commanded) < RunawayEnd;

    /// <summary>A servo will still move although the commanded position does not change: it lags behind, or was blocked and is free again.</summary>
    public bool IsSettling(double commanded, bool isOff) => !IsHeld && !isOff && Position != commanded;

    /// <summary>Sets the position value of the present shaft position, and with it the commanded position.</summary>
    public void Define(double position) => (Position, Lost) = (position, 0);

    /// <summary>Shifts all position values by this amount.</summary>
    public void Renumber(double difference) => Position += difference;
}
