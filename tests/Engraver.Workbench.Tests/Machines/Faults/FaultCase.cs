using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Simulator;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>Activity of the host during a fault.</summary>
internal enum HostActivity
{
    Run,

    /// <summary>The operator stops the run.</summary>
    Stop,

    /// <summary>A manual move.</summary>
    GoTo,

    /// <summary>A continuous jog.</summary>
    Jog,

    /// <summary>The machine, homed before and with an origin, is homed again.</summary>
    Home,

    /// <summary>A feed hold was requested and the path decelerates.</summary>
    Holding,

    /// <summary>The run is held.</summary>
    Held,

    /// <summary>The run resumes: the tool is switched on and the path moves.</summary>
    Resuming,

    /// <summary>A run that was stopped is resumed: in the path that is cut again before the place where it was stopped.</summary>
    LeadIn,

    /// <summary>The same, at any moment.</summary>
    Resume,

    /// <summary>The run is held and the machine is moved away manually.</summary>
    Away,

    /// <summary>The machine returns from there and the run continues.</summary>
    ComingBack,
}

/// <summary>Kind of machine.</summary>
internal enum MachineKind
{
    /// <summary>Two servos; an output is the tool.</summary>
    Pen,

    /// <summary>A tool axis and a spindle.</summary>
    Mill,

    /// <summary>Two steppers without encoders; an output is the tool.</summary>
    Stepper,
}

/// <summary>One fault at one moment of one activity, all drawn from the seed.</summary>
/// <param name="Fault">Its time is relative to the start of the activity, or of the tested part.</param>
/// <param name="At">Executed segments at which the operator stops the run or holds it.</param>
internal sealed record FaultCase(int Seed, MachineKind Machine, HostActivity Activity, JobMode Mode, ScheduledFault Fault, int At)
{
    /// <summary>Activities that test one part of a run start with that part; the fault waits for it.</summary>
    private static readonly HostActivity[] s_parts = [HostActivity.Holding, HostActivity.Held, HostActivity.Resuming, HostActivity.LeadIn, HostActivity.Away, HostActivity.ComingBack];

    private static readonly FaultKind[] s_kinds = Enum.GetValues<FaultKind>();
    private static readonly MachineKind[] s_machines = Enum.GetValues<MachineKind>();
    private static readonly HostActivity[] s_activities = Enum.GetValues<HostActivity>();

    /// <summary>Thirty seeds in a row hold every pair of kind and machine once, and every activity, the first 24 of them every kind on a pen and on a mill and
    /// what is special of steppers; 360 in a row every triple of kind, machine and activity. The moment is anywhere in the activity, by its clock, its bytes or
    /// its segments.</summary>
    /// <param name="extent">Extent of the activity without a fault.</param>
    public static FaultCase Create(int seed, Func<HostActivity, JobMode, MachineKind, ActivityExtent> extent)
    {
        var random = new Random(seed);
        var machine = seed / s_kinds.Length % s_machines.Length;
        var kind = (seed + (s_machines[machine] == MachineKind.Stepper ? (int)FaultKind.MotorOff : 0)) % s_kinds.Length;
        var activity = s_activities[(kind + (4 * machine) + (seed / (s_kinds.Length * s_machines.Length))) % s_activities.Length];
        var mode = (JobMode)random.Next(3);
        var whole = extent(activity, mode, s_machines[machine]);
        return new FaultCase(seed, s_machines[machine], activity, mode, Moment(FaultOf(s_kinds[kind], s_machines[machine], random), whole, random), random.Next(1, Math.Max(2, whole.Segments)));
    }

    /// <summary>The step by which a held run is moved away; null for one of the matrix.</summary>
    public CountsPoint? Step { get; init; }

    /// <summary>It is stopped there instead of resumed.</summary>
    public bool IsStoppedAway { get; init; }

    /// <summary>The activity is a run of a job, or a part of one.</summary>
    public bool IsRun => Activity is not (HostActivity.GoTo or HostActivity.Jog or HostActivity.Home);

    /// <summary>The fault happens in a part of the run.</summary>
    public bool IsOfPart => s_parts.Contains(Activity);

    /// <summary>The activity resumes a stopped run.</summary>
    public bool IsResumed => Activity is HostActivity.LeadIn or HostActivity.Resume;

    /// <summary>The operator holds the run.</summary>
    public bool IsHeld => Activity is HostActivity.Holding or HostActivity.Held or HostActivity.Resuming or HostActivity.Away or HostActivity.ComingBack;

    private static ScheduledFault FaultOf(FaultKind kind, MachineKind machine, Random random) => new()
    {
        Kind = kind,
        Axis = kind is FaultKind.LimitSwitch or FaultKind.MotorOff or FaultKind.Jam ? "ABC"[random.Next(machine == MachineKind.Mill ? 3 : 2)].ToString() : null,
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

/// <summary>Extent of an activity without a fault.</summary>
/// <param name="Segments">Segments of the whole run.</param>
internal sealed record ActivityExtent(double Seconds, long Bytes, int Segments)
{
    /// <summary>Seconds and bytes are those of a part of the run.</summary>
    public bool IsPart { get; init; }
}
