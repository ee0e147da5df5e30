namespace Engraver.Simulator.Motion;

/// <summary>The motor with its encoder: perfect, or a first-order lag behind the command (galil-dmc.md I.14). A stepper has no encoder in its loop: it does the
/// steps that it is sent, and those that come while its shaft is blocked are lost.</summary>
internal sealed class Motor(TimeSpan lag)
{
    private const double AlmostThere = 0.01;

    /// <summary>Share of its error by which a motor in a loop of the wrong sign goes further in a sample, and the counts that set it going.</summary>
    private const double RunawayShare = 0.05;
    private const double RunawayPush = 0.5;

    /// <summary>Counts that such a motor moves in a sample at its full speed.</summary>
    private const double RunawayStep = 200.0;

    /// <summary>Error at which the axis has run against its end, counts.</summary>
    private const double RunawayEnd = 100_000.0;

    private readonly double _share = lag <= TimeSpan.Zero ? 1 : 1 - Math.Exp(-Ramp.Sample / lag.TotalSeconds);

    /// <summary>Encoder position, counts; of a stepper where its shaft stands.</summary>
    public double Position { get; private set; }

    /// <summary>The shaft is blocked: the motor does not move and the position error grows.</summary>
    public bool IsHeld { get; set; }

    /// <summary>Steps that were sent to a stepper and that its shaft did not make, counts; 0 for a servo.</summary>
    public double Lost { get; private set; }

    /// <summary>Always at its commanded position: no lag, not blocked, no step lost.</summary>
    public bool IsPlain => _share >= 1 && !IsHeld && Lost == 0;

    public int Counts => (int)Math.Round(Position, MidpointRounding.AwayFromZero);

    /// <summary>A stepper is sent the steps to the commanded position.</summary>
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
        if (Math.Abs(commanded - Position) < AlmostThere) Position = commanded;
    }

    /// <summary>Moves for one sample away from the commanded position: the loop corrects every error in the wrong direction (motor or encoder reversed;
    /// galil-dmc.md C, MT and CE).</summary>
    public void RunAway(double commanded, bool isOff)
    {
        if (!WillRunOn(commanded, isOff)) return;
        var error = Position - commanded;
        Position += Math.CopySign(Math.Min(RunawayStep, (Math.Abs(error) * RunawayShare) + RunawayPush), error);
    }

    /// <summary>A motor in a loop of the wrong sign is still on its way.</summary>
    public bool WillRunOn(double commanded, bool isOff) => !IsHeld && !isOff && Math.Abs(Position - commanded) < RunawayEnd;

    /// <summary>A servo will still move although the commanded position does not change: it lags behind, or was blocked and is free again.</summary>
    public bool IsSettling(double commanded, bool isOff) => !IsHeld && !isOff && Position != commanded;

    /// <summary>The place where the shaft stands, and the commanded position with it, get this number.</summary>
    public void Define(double position) => (Position, Lost) = (position, 0);

    /// <summary>The numbers of all places change by this much.</summary>
    public void Renumber(double difference) => Position += difference;
}
