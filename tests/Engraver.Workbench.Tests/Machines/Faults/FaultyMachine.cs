using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Galil.Links;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>A simulated controller to which one fault happens, and hosts that come to it one after the other; what is known of the machine is kept between them.</summary>
internal sealed class FaultyMachine : IAsyncDisposable
{
    /// <summary>Path that is cut again before the place where a run was interrupted, mm.</summary>
    public const double LeadIn = 2.0;

    private const string Address = "tcp://faulty:1";
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-fault-");
    private readonly SimulatedController _controller;
    private readonly MachineProfile _profile;
    private int _journals;
    private bool _happened;

    /// <param name="hasHoming">A machine with travel and switches, which is homed; otherwise one that is placed by its counts alone.</param>
    public FaultyMachine(bool hasHoming)
    {
        _profile = hasHoming ? Homing : MachineProfile.Default;
        _controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, SerialNumber = 77, Switches = SimulatedMachine.Switches(_profile) });
    }

    private static MachineProfile Homing { get; } = MachineProfile.Default with
    {
        Axes = new MachineAxes(
            new MachineAxis('A', 1000) { Homing = new AxisHoming { By = HomingMark.Limit, Zero = -1, BackOff = 1, Order = 1 }, Travel = new AxisTravel(0, 60) },
            new MachineAxis('B', 1000) { Homing = new AxisHoming { By = HomingMark.Switch, Plus = true, Zero = 30, BackOff = 2 }, Travel = new AxisTravel(0, 29) }),
    };

    public SimulatedController Controller => _controller;

    public double Seconds => _controller.Status.Sample / 1000.0;

    /// <summary>Rows of the record so far.</summary>
    public int Rows => _controller.Record.Count;

    private MachineMemories Memories => new(Path.Combine(_folder.FullName, "machines"));

    /// <summary>The fault happens at its moment from now on; once.</summary>
    public void Happen(ScheduledFault fault)
    {
        if (_happened) return;
        _happened = true;
        _controller.Schedule(fault with { AtSeconds = fault.AtSeconds + Seconds, AtByte = fault.AtByte + _controller.BytesArrived, AtSegment = fault.AtSegment + _controller.Status.SegmentsExecuted });
    }

    /// <summary>Cuts the part, or what is left of it, and judges what was cut by every sample of the record.</summary>
    /// <param name="watched">Who stops, holds and resumes; null for nobody.</param>
    /// <param name="since">Row of the record from which on it is judged: that of the run whose journal is resumed; null: from now on.</param>
    /// <param name="resumed">The journal of an interrupted run; null for a run from the beginning.</param>
    public async Task<FaultyRun> RunAsync(JobMode mode, Func<CancellationTokenSource, FaultOperator>? watched, CancellationToken limit, int? since = null, string? resumed = null)
    {
        var job = Job(mode);
        var from = since ?? Rows;
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(limit);
        var watcher = watched?.Invoke(stop);
        await using var connection = Connection();
        var options = new MachineRunOptions(new TcpAddress("faulty", 1), mode)
        {
            JournalPath = Journal(),
            Memories = Memories,
            Holder = "a test",
            Control = watcher?.Control,
            Resume = resumed is null ? null : new ResumeRequest { Journal = resumed, LeadInMm = LeadIn },
        };
        try
        {
            var report = await MachineRun.RunAsync(job, job.Motion.Program!, connection, options, TimeProvider.System, watcher, stop.Token);
            var cut = _controller.Record.Snapshot().Skip(from).ToList();
            return new FaultyRun(report.Result, (report.Placement?.Refusal ?? report.ResumeRefusal)?.Id, Judged(job, cut, report.Result.FrameOrigin), CutRecord.Length(cut))
            {
                Tolerance = RunJudge.Tolerances(job).Deviation,
                Journal = options.JournalPath,
                LongestBurn = CutRecord.LongestBurn(cut),
                Zero = report.Result.FrameOrigin is { } frame ? new CountsPoint(_controller.PlaceOf(0, frame.X), _controller.PlaceOf(1, frame.Y)) : null,
            };
        }
        catch (ControllerException unconnected)
        {
            return FaultyRun.Unconnected(unconnected.Message);
        }
    }

    /// <summary>Moves by hand to a place.</summary>
    public Task<FaultyRun> GoToAsync(CountsPoint goal, CancellationToken limit) => MoveAsync(MachineMove.To(goal, withHeight: false, isStep: false, _profile, Journal(), new Progress<JobProgress>()), limit);

    /// <summary>Moves by hand until the machine has gone so far.</summary>
    /// <param name="far">Counts of the first axis.</param>
    public Task<FaultyRun> JogAsync(JogVelocity velocity, int far, CancellationToken limit)
    {
        var control = new JogControl(velocity);
        return MoveAsync(MachineMove.Jog(control, Journal(), new ReleaseAt(far, control)), limit);
    }

    /// <summary>Homes the machine.</summary>
    public async Task<FaultyRun> HomeAsync(CancellationToken limit)
    {
        await using var connection = Connection();
        try
        {
            using var hold = await TakeAsync(connection, limit);
            var homed = await MachineHoming.RunAsync(connection, hold, _profile, default, Journal(), new Progress<JobProgress>(), TimeProvider.System, limit);
            return new FaultyRun(homed.Result, null, RunJudgement.Unknown, 0.0);
        }
        catch (ControllerException unconnected)
        {
            return FaultyRun.Unconnected(unconnected.Message);
        }
    }

    /// <summary>Sets the work origin.</summary>
    public async Task SetOriginAsync(int x, int y, CancellationToken limit)
    {
        await using var connection = Connection();
        using var hold = await TakeAsync(connection, limit);
        using var clock = connection.TakeClock();
        await using var machine = await clock.ShakeHandsAsync(connection, trace: null, limit);
        await JobPlacement.SetOriginAsync(machine, _profile.Axes, hold, (memory, _) => memory.WithOrigin("G54", x, y, null), TimeProvider.System, limit);
    }

    /// <summary>Lets everything that moves come to rest, with nobody connected.</summary>
    public ControllerStatus Rest() => _controller.AdvanceToRest(TimeSpan.FromMinutes(20), TimeSpan.FromSeconds(30), 5_000_000).Status;

    public async ValueTask DisposeAsync()
    {
        await _controller.DisposeAsync();
        _folder.Delete(recursive: true);
    }

    private async Task<FaultyRun> MoveAsync(MachineMove move, CancellationToken limit)
    {
        await using var connection = Connection();
        try
        {
            using var hold = await TakeAsync(connection, limit);
            return new FaultyRun(await move.RunAsync(connection, hold, _profile, default, limit), null, RunJudgement.Unknown, 0.0);
        }
        catch (ControllerException unconnected)
        {
            return FaultyRun.Unconnected(unconnected.Message);
        }
    }

    private async Task<MachineHold> TakeAsync(MachineConnection connection, CancellationToken limit)
    {
        using var clock = connection.TakeClock();
        await using var machine = await clock.ShakeHandsAsync(connection, trace: null, limit);
        return Memories.Take(Address, machine.Identity, await machine.LocateAsync(MachineAxes.Default, limit), "a test");
    }

    private MachineConnection Connection() => MachineConnection.Through(
        Address, _ => Task.FromResult<IControllerLink>(new StreamLink(_controller.OpenConnection(), Address)), () => MachineClock.FromSimulator(_controller.JoinClock()));

    private string Journal() => Path.Combine(_folder.FullName, $"run{_journals++}.jsonl");

    private PreparedJob Job(JobMode mode)
    {
        var path = Path.Combine(_folder.FullName, "part.dxf");
        var settings = new DrawingSettings { Machine = _profile };
        File.WriteAllBytes(path, Part());
        return JobPreparation.Prepare(DrawingFile.Open(path, settings, CancellationToken.None), settings, JobPlan.StyleOf(mode));
    }

    private static RunJudgement Judged(PreparedJob job, List<MotionSample> cut, CountsPoint? frame) =>
        frame is { } at && cut.Count > 0 ? RecordJudgement.Of(job, cut, at.X, at.Y) : RunJudgement.Unknown;

    /// <summary>A plate of lines with a hole and an open slanting line: 64 mm to cut.</summary>
    private static byte[] Part()
    {
        var part = new List<(int Code, object Value)>();
        void Line(double x1, double y1, double x2, double y2) => part.AddRange([(0, "LINE"), (8, "0"), (10, x1), (20, y1), (11, x2), (21, y2)]);
        Line(2, 2, 14, 2);
        Line(14, 2, 14, 9);
        part.AddRange([(0, "ARC"), (8, "0"), (10, 8.0), (20, 9.0), (40, 6.0), (50, 0.0), (51, 180.0)]);
        Line(2, 9, 2, 2);
        part.AddRange([(0, "CIRCLE"), (8, "0"), (10, 8.0), (20, 6.0), (40, 1.5)]);
        Line(-2, -3, -9, -6);
        return DxfText.WithEntities([.. part]).ToAscii();
    }

    private sealed class ReleaseAt(int far, JogControl control) : IProgress<JobProgress>
    {
        public void Report(JobProgress value)
        {
            if (Math.Abs(value.X) >= far) control.Release();
        }
    }
}

/// <summary>What the record says of the tool.</summary>
internal static class CutRecord
{
    /// <summary>Length of the way on which the tool was on, counts.</summary>
    public static double Length(IReadOnlyList<MotionSample> samples)
    {
        var length = 0.0;
        for (var i = 1; i < samples.Count; i++)
        {
            if ((samples[i].Outputs & 1) != 0 && (samples[i - 1].Outputs & 1) != 0) length += Math.Sqrt(Square(samples[i].A - samples[i - 1].A) + Square(samples[i].B - samples[i - 1].B));
        }

        return length;

        static double Square(double value) => value * value;
    }

    /// <summary>The longest time for which the tool was on while nothing moved, samples.</summary>
    public static long LongestBurn(IReadOnlyList<MotionSample> samples)
    {
        var longest = 0L;
        for (var i = 1; i < samples.Count; i++)
        {
            if ((samples[i - 1].Outputs & 1) != 0) longest = Math.Max(longest, samples[i].Sample - samples[i - 1].Sample);
        }

        return longest;
    }
}

/// <summary>How an activity ended by its own account, and what the motors did.</summary>
/// <param name="Result">Null when the link never came up.</param>
/// <param name="Refusal">Id of the finding that forbade it because nobody knows where the work is.</param>
/// <param name="CutCounts">Way with the tool on, counts.</param>
internal sealed record FaultyRun(JobResult? Result, string? Refusal, RunJudgement Record, double CutCounts)
{
    public double Tolerance { get; init; }

    public string Sentence { get; private init; } = Result?.Sentence ?? "";

    /// <summary>Path of the run's journal; empty for a move.</summary>
    public string Journal { get; init; } = "";

    /// <summary>The longest time for which the tool was on while nothing moved, samples.</summary>
    public long LongestBurn { get; init; }

    /// <summary>Where the drawing's zero really lay, counts from the first power up; null where nothing began.</summary>
    public CountsPoint? Zero { get; init; }

    public bool IsComplete => Result is { Outcome: JobOutcome.Complete };

    public bool IsCutRight => Record is { MaxDeviationMm: { } deviation, MissingLengthMm: { } missing } && deviation <= Tolerance && missing <= Tolerance;

    public static FaultyRun Unconnected(string sentence) => new(null, null, RunJudgement.Unknown, 0.0) { Sentence = sentence };

    public override string ToString() => $"{Result?.Outcome.ToString() ?? "unconnected"} {Refusal} '{Sentence}' deviation {Record.MaxDeviationMm} missing {Record.MissingLengthMm} cut {CutCounts:0} zero {Zero} burn {LongestBurn}";
}
