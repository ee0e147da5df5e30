using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Language;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using Engraver.Links;
using Engraver.Simulator;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines.Faults;

/// <summary>A simulated controller with one fault, and consecutive hosts; the stored state of the machine is kept between them.</summary>
internal sealed class FaultyMachine : IAsyncDisposable
{
    /// <summary>Lead-in of a resumed run, mm.</summary>
    public const double LeadIn = 2.0;

    /// <summary>Maximum deviation of the tool from the drawing, regardless of communication faults: three counts.</summary>
    public const double MostBesideMm = 0.003;

    private const string Address = "tcp://faulty:1";
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-fault-");
    private readonly SimulatedController _controller;
    private readonly MachineProfile _profile;
    private int _journals;
    private bool _happened;

    private readonly MachineKind _kind;

    /// <param name="hasHoming">A machine with travel and switches, with homing; otherwise one that is positioned only by its counts.</param>
    public FaultyMachine(MachineKind kind, bool hasHoming)
        : this(ProfileOf(kind, hasHoming), kind)
    {
    }

    public FaultyMachine(MachineProfile profile, MachineKind kind)
    {
        _kind = kind;
        _profile = profile;
        View = new OperatorView(_profile);
        _controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, SerialNumber = 77, Switches = SimulatedSwitches.Switches(_profile) });
    }

    /// <summary>The operator's view.</summary>
    public OperatorView View { get; }

    /// <summary>True with a tool axis.</summary>
    public bool HasHeight => _profile.Height is not null;

    /// <summary>The height of the top of the work, counts of the machine as it was switched on first.</summary>
    public int TopOfWork { get; private set; }

    /// <summary>Sets the machine height of the work, current counts of the controller.</summary>
    public void PutWorkAt(int height) => TopOfWork = _controller.PlaceOf(2, height);

    /// <summary>The tool's height, the same counts; 0 where an output is the tool.</summary>
    public int ToolHeight => HasHeight ? _controller.MotorPlace(2) : 0;

    /// <summary>Travel height of a tool axis above the work.</summary>
    public int Clearance => _profile.ClearanceCounts;

    private static MachineProfile ProfileOf(MachineKind kind, bool hasHoming)
    {
        var (x, y) = (new MachineAxis('A', 1000), new MachineAxis('B', 1000));
        if (hasHoming) (x, y) = (x with { Homing = new AxisHoming { By = HomingMark.Limit, Zero = -1, BackOff = 1, Order = 2 }, Travel = new AxisTravel(0, 60) }, y with { Homing = new AxisHoming { By = HomingMark.Switch, Plus = true, Zero = 30, BackOff = 2, Order = 1 }, Travel = new AxisTravel(0, 29) });
        if (kind == MachineKind.Stepper) (x, y) = (x with { MotorType = -2.0 }, y with { MotorType = 2.0 });
        var z = new MachineAxis('C', 800) { Homing = hasHoming ? new AxisHoming { By = HomingMark.Switch, Plus = true, Zero = 20, BackOff = 2 } : null };
        return kind != MachineKind.Mill
            ? MachineProfile.Default with { Axes = new MachineAxes(x, y) }
            : MachineProfile.Default with
            {
                Axes = new MachineAxes(x, y, z),
                Height = new HeightDrive { ClearanceHeight = 4.0, RetractHeight = 1.0, CutDepth = 0.5, PlungeMmPerMinute = 240.0 },
                Spindle = new Spindle { Output = 3, SpinUpSeconds = 0.2 },
            };
    }

    /// <summary>The operator has set the origin again: a run is resumed there, regardless of where it was started.</summary>
    public bool IsSetAnew { get; private set; }

    public SimulatedController Controller => _controller;

    public double Seconds => _controller.Status.Sample / 1000.0;

    /// <summary>Rows of the record so far.</summary>
    public int Rows => _controller.Record.Count;

    private MachineMemories Memories => new(Path.Combine(_folder.FullName, "machines"));

    /// <summary>A controller with steppers is configured before use: MT is burned (galil-dmc.md A.6).</summary>
    public async Task BurnAsync(CancellationToken limit)
    {
        if (_kind == MachineKind.Stepper) await SendAsync(limit, "MO AB", "MTA=-2", "MTB=2", "SH AB", "BN");
    }

    /// <summary>Sends commands like another host.</summary>
    public async Task SendAsync(CancellationToken limit, params string[] commands)
    {
        await using var channel = new CommandChannel(new StreamLink(_controller.OpenConnection(), Address), "else", TimeSpan.FromSeconds(60), TimeProvider.System, null);
        foreach (var command in commands) Assert.IsType<Accepted>(await channel.SendAsync(command, limit));
    }

    /// <summary>Removes the effects of a fault: switch, input and shaft.</summary>
    public void Free(ScheduledFault fault)
    {
        var axis = fault.Axis is [var letter] ? letter - 'A' : 0;
        switch (fault.Kind)
        {
            case FaultKind.LimitSwitch: _controller.SetLimitSwitch(axis, fault.Forward, active: false); break;
            case FaultKind.AbortInput: _controller.SetAbortInput(active: false); break;
            case FaultKind.Jam: _controller.HoldMotor(axis, held: false); break;
            default: break;
        }
    }

    /// <summary>Polls the machine: the status according to the controller.</summary>
    /// <returns>Null if it does not answer.</returns>
    public async Task<MachineStatus?> PollAsync(CancellationToken limit)
    {
        await using var connection = Connection();
        try
        {
            using var clock = connection.CreateClock();
            await using var machine = await clock.HandshakeAsync(connection, trace: null, limit);
            var place = await machine.ReadPositionAsync(_profile.Axes, limit);
            using var hold = Memories.Acquire(Address, machine.Identity, place, "a test");
            View.Connected(Address, machine.Identity);
            View.Poll(await machine.ReadStatusAsync(_profile.Axes, limit), hold, place);
            return View.Status;
        }
        catch (ControllerException)
        {
            return null;
        }
    }

    /// <summary>Inputs, limits and motors reported by the controller, by letters; queried individually.</summary>
    public async Task<MachineTruth> AskTruthAsync(CancellationToken limit)
    {
        await using var channel = new CommandChannel(new StreamLink(_controller.OpenConnection(), Address), "truth", TimeSpan.FromSeconds(60), TimeProvider.System, null);
        async Task<double> Ask(string operand) => (await channel.ReadAsync(operand, limit)).Values[0];
        var (limits, off, error) = ("", "", "");
        foreach (var letter in _profile.Axes.Letters)
        {
            if (await Ask($"_LF{letter}") == 0.0 || await Ask($"_LR{letter}") == 0.0) limits += letter;
            if (await Ask($"_MO{letter}") != 1.0) continue;
            off += letter;
            if (await Ask($"_SC{letter}") == 8.0) error += letter;
        }

        return new MachineTruth(await Ask("_AB") == 0.0, limits, off, error);
    }

    /// <summary>Switches the motors on.</summary>
    /// <returns>Why not; empty on success.</returns>
    public async Task<string> SwitchMotorsOnAsync(CancellationToken limit)
    {
        await using var connection = Connection();
        using var clock = connection.CreateClock();
        await using var machine = await clock.HandshakeAsync(connection, trace: null, limit);
        return (await machine.SetMotorsAsync(_profile.Axes, on: true, limit))?.Message ?? "";
    }

    /// <summary>Sets the origin again at the position of the work, regardless of the controller's current zero.</summary>
    public Task SetOriginAnewAsync(CancellationToken limit)
    {
        IsSetAnew = true;
        return SetOriginAsync(-_controller.PlaceOf(0, 0), -_controller.PlaceOf(1, 0), limit);
    }

    /// <summary>Schedules the fault relative to now, once.</summary>
    public void Inject(ScheduledFault fault)
    {
        if (_happened) return;
        _happened = true;
        _controller.Schedule(fault with { AtSeconds = fault.AtSeconds + Seconds, AtByte = fault.AtByte + _controller.BytesArrived, AtSegment = fault.AtSegment + _controller.Status.SegmentsExecuted });
    }

    /// <summary>Cuts the part or its rest, and judges the cut by every sample of the record.</summary>
    /// <param name="watched">The operator who stops, holds and resumes; null for none.</param>
    /// <param name="since">Row of the record from which on it is judged: that of the run whose journal is resumed; null: from now on.</param>
    /// <param name="resumed">The journal of an interrupted run; null for a run from the beginning.</param>
    public async Task<FaultyRun> RunAsync(JobMode mode, Func<CancellationTokenSource, FaultOperator>? watched, CancellationToken limit, int? since = null, string? resumed = null)
    {
        var job = Job(mode);
        var from = since ?? Rows;
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(limit);
        var watcher = watched?.Invoke(stop);
        await using var connection = Connection();
        var options = new MachineRunOptions(new TcpAddress("faulty", 1), mode.Strategy())
        {
            JournalPath = Journal(),
            Memories = Memories,
            LeaseOwner = "a test",
            Control = watcher?.Control,
            Resume = resumed is null ? null : new ResumeRequest { Journal = resumed, LeadInMm = LeadIn, AtOrigin = IsSetAnew },
        };
        View.Start(move: null);
        try
        {
            var report = await MachineRun.RunAsync(job, job.Motion.Program!, connection, options, TimeProvider.System, new ProgressTap(View, isJob: true, watcher), stop.Token);
            View.End(report.Result, isJob: true);
            var cut = CutRecord.Placed(_controller.Record.Snapshot(), from, isFollowed: !_profile.HasHoming);
            var frame = _profile.HasHoming ? report.Result.FrameOrigin : default(CountsPoint);
            return new FaultyRun(report.Result, (report.Placement?.Refusal ?? report.ResumeRefusal)?.Id, Judged(job, cut, frame), CutRecord.Length(cut, IsAtWork(frame)))
            {
                Tolerance = RunJudge.Tolerances(job).Deviation,
                Journal = options.JournalPath,
                OpenLoop = string.Concat(report.OpenLoop),
                LongestBurn = CutRecord.LongestDwell(cut, IsAtWork(frame)),
                Zero = report.Result.FrameOrigin is { } taken ? new CountsPoint(_controller.PlaceOf(0, (int)taken.X), _controller.PlaceOf(1, (int)taken.Y)) : null,
            };
        }
        catch (ControllerException unconnected)
        {
            View.End(result: null, isJob: true);
            return FaultyRun.Unconnected(unconnected.Message);
        }
    }

    /// <summary>Whether the tool is in the work in a sample: its output is on, or it is below the travel height.</summary>
    private Func<MotionSample, bool> IsAtWork(CountsPoint? frame)
    {
        var travel = (frame?.Z ?? 0) + _profile.RetractCounts;
        return HasHeight ? sample => sample.C < travel && (sample.Outputs & 4) != 0 : static sample => (sample.Outputs & 1) != 0;
    }

    /// <summary>Moves manually to a position.</summary>
    public Task<FaultyRun> GoToAsync(CountsPoint goal, CancellationToken limit) => MoveAsync(MachineMove.GoTo(goal, _profile, Journal(), new ProgressTap(View, isJob: false)), limit);

    /// <summary>Jogs until the machine has moved a distance.</summary>
    /// <param name="far">Counts of the first axis.</param>
    public Task<FaultyRun> JogAsync(JogVelocity velocity, int far, CancellationToken limit)
    {
        var control = new JogControl(velocity);
        return MoveAsync(MachineMove.Jog(control, Journal(), new ProgressTap(View, isJob: false, new ReleaseAt(far, control))), limit);
    }

    /// <summary>Homes the machine.</summary>
    public async Task<FaultyRun> HomeAsync(CancellationToken limit)
    {
        await using var connection = Connection();
        View.Start("homing");
        try
        {
            using var hold = await TakeAsync(connection, limit);
            var homed = await MachineHoming.RunAsync(connection, hold, _profile, default, Journal(), new ProgressTap(View, isJob: false), TimeProvider.System, limit);
            View.End(homed.Result, isJob: false);
            return new FaultyRun(homed.Result, null, RunJudgement.Unknown, 0.0);
        }
        catch (ControllerException unconnected)
        {
            View.End(result: null, isJob: false);
            return FaultyRun.Unconnected(unconnected.Message);
        }
    }

    /// <summary>Sets the work origin, at the top of the work with a tool axis.</summary>
    public async Task SetOriginAsync(int x, int y, CancellationToken limit)
    {
        await using var connection = Connection();
        using var hold = await TakeAsync(connection, limit);
        using var clock = connection.CreateClock();
        await using var machine = await clock.HandshakeAsync(connection, trace: null, limit);
        await JobPlacement.SetOriginAsync(machine, _profile, hold, (memory, _) => memory.WithOrigin("G54", x, y, HasHeight ? TopOfWork - _controller.PlaceOf(2, 0) : null), TimeProvider.System, limit);
    }

    /// <summary>Lets everything that moves come to rest, without a connection.</summary>
    public ControllerStatus Rest() => _controller.AdvanceToRest(TimeSpan.FromMinutes(20), TimeSpan.FromSeconds(30), 5_000_000).Status;

    public async ValueTask DisposeAsync()
    {
        View.Dispose();
        await _controller.DisposeAsync();
        _folder.Delete(recursive: true);
    }

    private async Task<FaultyRun> MoveAsync(MachineMove move, CancellationToken limit)
    {
        await using var connection = Connection();
        View.Start(move.Name);
        try
        {
            using var hold = await TakeAsync(connection, limit);
            var result = await move.RunAsync(connection, hold, _profile, default, limit);
            View.End(result, isJob: false);
            return new FaultyRun(result, null, RunJudgement.Unknown, 0.0);
        }
        catch (ControllerException unconnected)
        {
            View.End(result: null, isJob: false);
            return FaultyRun.Unconnected(unconnected.Message);
        }
    }

    private async Task<MachineLease> TakeAsync(MachineConnection connection, CancellationToken limit)
    {
        using var clock = connection.CreateClock();
        await using var machine = await clock.HandshakeAsync(connection, trace: null, limit);
        return Memories.Acquire(Address, machine.Identity, await machine.ReadPositionAsync(_profile.Axes, limit), "a test");
    }

    private MachineConnection Connection() => MachineConnection.FromLink(
        Address, _ => Task.FromResult<IControllerLink>(new StreamLink(_controller.OpenConnection(), Address)), () => MachineClock.FromSimulator(_controller.JoinClock()));

    private string Journal() => Path.Combine(_folder.FullName, $"run{_journals++}.jsonl");

    private PreparedJob Job(JobMode mode)
    {
        var path = Path.Combine(_folder.FullName, "part.dxf");
        var settings = new DrawingSettings { Machine = _profile };
        File.WriteAllBytes(path, Part());
        return JobPreparation.Prepare(DrawingFile.Open(path, settings, CancellationToken.None), settings, mode.Strategy().Style);
    }

    private static RunJudgement Judged(PreparedJob job, List<MotionSample> cut, CountsPoint? frame) =>
        frame is { } at && cut.Count > 0 ? RecordJudgement.Of(job, cut, at.X, at.Y, at.Z) : RunJudgement.Unknown;

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

    /// <summary>Forwards progress synchronously to the operator's view first.</summary>
    private sealed class ProgressTap(OperatorView view, bool isJob, IProgress<JobProgress>? next = null) : IProgress<JobProgress>
    {
        public void Report(JobProgress value)
        {
            view.Progress(value, isJob);
            next?.Report(value);
        }
    }

    private sealed class ReleaseAt(int far, JogControl control) : IProgress<JobProgress>
    {
        public void Report(JobProgress value)
        {
            if (Math.Abs(value.X) >= far) control.Release();
        }
    }
}

/// <summary>Reported result of an activity, and the actual motion.</summary>
/// <param name="Result">Null if the link could not be established.</param>
/// <param name="Refusal">Id of the finding that refused it because the work origin is unknown.</param>
/// <param name="CutCounts">Length with the tool on, counts.</param>
internal sealed record FaultyRun(JobResult? Result, string? Refusal, RunJudgement Record, double CutCounts)
{
    public double Tolerance { get; init; }

    public string Sentence { get; private init; } = Result?.Message ?? "";

    /// <summary>Axes with commanded positions only, according to the report of the run.</summary>
    public string OpenLoop { get; init; } = "";

    /// <summary>Path of the run's journal; empty for a move.</summary>
    public string Journal { get; init; } = "";

    /// <summary>The longest time for which the tool was on while nothing moved, samples.</summary>
    public long LongestBurn { get; init; }

    /// <summary>Actual position of the drawing's zero, counts since the first power-on; null if nothing started.</summary>
    public CountsPoint? Zero { get; init; }

    public bool IsComplete => Result is { Outcome: JobOutcome.Complete };

    /// <summary>The largest following error of healthy servos of this machine, mm: 0.5 mm and 0.07 s of 20 mm/s.</summary>
    public const double HealthyFollowingMm = 0.5 + (0.07 * 20.0);

    /// <summary>The commanded path is the drawing, and the motors were never farther from it than healthy servos may be.</summary>
    public bool IsCutRight => IsCutRightWithin(HealthyFollowingMm);

    /// <summary>The commanded path is the drawing, and the motors were never farther from it than this, mm.</summary>
    public bool IsCutRightWithin(double following) => Record is { MaxDeviationMm: { } deviation, MissingLengthMm: { } missing } && (Record.CommandedDeviationMm ?? deviation) <= Tolerance && missing <= Tolerance && (Record.FollowingMm ?? 0.0) <= following;

    /// <summary>It was refused because the job that it resumes had been cut to its end.</summary>
    public bool IsNothingLeft => Refusal is not null && Sentence.Contains("nothing is left to cut", StringComparison.Ordinal);

    public static FaultyRun Unconnected(string sentence) => new(null, null, RunJudgement.Unknown, 0.0) { Sentence = sentence };

    public override string ToString() => $"{Result?.Outcome.ToString() ?? "unconnected"} {Refusal} '{Sentence}' deviation {Record.MaxDeviationMm} commanded {Record.CommandedDeviationMm} following {Record.FollowingMm} missing {Record.MissingLengthMm} cut {CutCounts:0} zero {Zero} burn {LongestBurn}";
}

/// <summary>State reported by the controller.</summary>
/// <param name="Limits">Axes on a limit switch.</param>
/// <param name="Off">Axes without current.</param>
/// <param name="OffByError">Those of them that were switched off because of their position error.</param>
internal sealed record MachineTruth(bool Abort, string Limits, string Off, string OffByError);
