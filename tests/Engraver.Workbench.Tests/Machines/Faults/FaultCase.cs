using Engraver.Core.Machines;
using Engraver.Simulator;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>What the host does while a fault happens.</summary>
internal enum HostActivity
{
    Run,

    /// <summary>The operator stops the run.</summary>
    Stop,

    /// <summary>A move by hand.</summary>
    GoTo,

    /// <summary>A move for as long as a key is held.</summary>
    Jog,

    /// <summary>The machine, homed before and with an origin, is homed again.</summary>
    Home,

    /// <summary>A hold was asked for and the path brakes.</summary>
    Holding,

    /// <summary>The run stands held.</summary>
    Held,

    /// <summary>The hold was taken back: the tool goes on again and the path moves.</summary>
    Resuming,

    /// <summary>A run that was stopped is resumed: in the path that is cut again before the place where it was stopped.</summary>
    LeadIn,

    /// <summary>The same, at any moment.</summary>
    Resume,
}

/// <summary>One fault at one moment of one activity, all drawn from the seed.</summary>
/// <param name="Fault">Its moment counts from where the activity begins, or the part of it that it is about.</param>
/// <param name="At">Executed segments at which the operator stops the run or holds it.</param>
internal sealed record FaultCase(int Seed, HostActivity Activity, JobMode Mode, ScheduledFault Fault, int At)
{
    private static readonly FaultKind[] s_kinds = Enum.GetValues<FaultKind>();
    private static readonly HostActivity[] s_activities = Enum.GetValues<HostActivity>();

    /// <summary>A hundred seeds in a row hold every pair of kind and activity once, ten in a row every kind and every activity. The moment is anywhere in the activity, by its clock, its bytes or its segments.</summary>
    /// <param name="extent">What the activity takes when nothing goes wrong.</param>
    public static FaultCase Create(int seed, Func<HostActivity, JobMode, ActivityExtent> extent)
    {
        var random = new Random(seed);
        var kind = s_kinds[seed % s_kinds.Length];
        var activity = s_activities[(seed + (seed / s_kinds.Length)) % s_activities.Length];
        var mode = (JobMode)random.Next(3);
        var whole = extent(activity, mode);
        return new FaultCase(seed, activity, mode, Moment(FaultOf(kind, random), whole, random), random.Next(1, Math.Max(2, whole.Segments)));
    }

    /// <summary>The activity is a run of a job, or a part of one.</summary>
    public bool IsRun => Activity is not (HostActivity.GoTo or HostActivity.Jog or HostActivity.Home);

    private static ScheduledFault FaultOf(FaultKind kind, Random random) => new()
    {
        Kind = kind,
        Axis = kind is FaultKind.LimitSwitch or FaultKind.MotorOff or FaultKind.Jam ? (random.Next(2) == 0 ? "A" : "B") : null,
        Forward = kind == FaultKind.LimitSwitch && random.Next(2) == 0,
        ForSeconds = kind is FaultKind.LimitSwitch or FaultKind.AbortInput or FaultKind.Jam && random.Next(2) == 0 ? 0.05 + (2.0 * random.NextDouble()) : null,
        Seconds = kind == FaultKind.Delay ? new[] { 0.02, 0.2, 0.7, 3.0 }[random.Next(4)] : 0.5,
        Count = 1 + random.Next(kind == FaultKind.Garbage ? 12 : 3),
    };

    private static ScheduledFault Moment(ScheduledFault fault, ActivityExtent whole, Random random) => random.Next(whole.Segments > 0 && !whole.IsPart ? 3 : 2) switch
    {
        0 => fault with { AtSeconds = random.NextDouble() * whole.Seconds },
        1 => fault with { AtByte = random.NextInt64(whole.Bytes) },
        _ => fault with { AtSegment = random.Next(whole.Segments) },
    };
}

/// <summary>What an activity takes of the controller when nothing goes wrong.</summary>
/// <param name="Segments">Segments of the whole run.</param>
internal sealed record ActivityExtent(double Seconds, long Bytes, int Segments)
{
    /// <summary>Seconds and bytes are those of a part of the run.</summary>
    public bool IsPart { get; init; }
}
