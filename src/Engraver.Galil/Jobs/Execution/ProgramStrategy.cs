using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using static Engraver.Galil.Jobs.JobMachine;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Runs the job in the controller, one chunk after another; the next one is loaded while the machine is at rest with the tool off
/// (galil-dmc.md F.1 method 2).</summary>
/// <remarks>
/// While a program is loaded no thread watches the machine, so a spindle stands meanwhile; it is switched on once the program waits behind its first rapid,
/// with its watchdog at work.
/// No operand reports how many lines the program memory holds (galil-dmc.md 0.3: 1000, not confirmed), so the download itself tests it: when it is refused
/// for too many lines, the rest of the job is packed for half as many.
/// </remarks>
internal sealed class ProgramStrategy(MotionProgram program, JobMachine machine, JobLedger ledger, JobLog log, ProgramMemory memory, JobOptions options) : IJobStrategy
{
    /// <summary>The override is fitted to the sequences that may be run before it can be changed again, seconds at the fastest override.</summary>
    private const double SecondsAhead = 1.5;

    private readonly ExecutedPath _path = new(program, ledger, log);
    private int _memoryLines = DmcLimits.ProgramLines;
    private ChunkProgress? _chunk;
    private IReadOnlyList<VectorSequence> _sequences = [];
    private int _borne = -1;

    public ValueTask<JobStep> StartAsync()
    {
        machine.Tool.TurnsForProgram = true;
        return new(JobStep.Done);
    }

    public async ValueTask<JobStep> CutAsync()
    {
        if (program.Strokes.Count == 0) return JobStep.Done;
        var job = new SupervisedProgram(program, machine.ControllerFrame, options.DryRun);
        var waiting = Packed(job, program.Strokes);
        while (waiting.TryPeek(out var chunk))
        {
            if (await machine.Hold.GateAsync().ConfigureAwait(false) is { Ends: true } held) return held;
            if (await LoadAsync(chunk).ConfigureAwait(false) is not { Ends: true } loaded) waiting.Dequeue();
            else if (IsTooLong(loaded) && _memoryLines / 2 >= job.FewestLines)
            {
                _memoryLines /= 2;
                waiting = Packed(job, [.. waiting.SelectMany(later => later.Parts)]);
                continue;
            }
            else return Refused(loaded);

            if (await RunAsync(chunk).ConfigureAwait(false) is { Ends: true } end) return end;
        }

        return JobStep.Done;
    }

    public async ValueTask StoppedAsync(int counter)
    {
        if (_chunk is null || await machine.AskAtRestAsync(ResidentProgram.Variables.Sequence).ConfigureAwait(false) is not { } mark) return;
        _path.ConfirmUpTo(_chunk.Executed((int)mark, counter));
    }

    private Queue<ProgramChunk> Packed(SupervisedProgram job, IReadOnlyList<MotionStroke> strokes)
    {
        var packed = job.Pack(strokes, _memoryLines, options.SourceOf);
        if (_path.Count == 0) ledger.Diagnostics.Clear();
        ledger.Diagnostics.AddRange(packed.Diagnostics);
        return new Queue<ProgramChunk>(packed.Chunks);
    }

    /// <summary>No thread may run while the memory changes; the watchdog is stopped too, while the machine is at rest and its spindle stands.</summary>
    private async ValueTask<JobStep> LoadAsync(ProgramChunk chunk)
    {
        _chunk = null;
        if (await machine.Tool.TurnAsync(on: false).ConfigureAwait(false) is { Ends: true } turning) return turning;
        if (await machine.HaltProgramAsync().ConfigureAwait(false) is { Ends: true } running) return running;
        return await memory.SwapAsync(chunk.Text, machine.Stop).ConfigureAwait(false) is { } refused ? JobStep.Refused(refused, "") : JobStep.Done;
    }

    private static bool IsTooLong(JobStep loaded) => loaded.Refusal is { Code: TcCode.DownloadError, Command: "DL" };

    private JobStep Refused(JobStep loaded)
    {
        if (loaded.Refusal is { Command: "DL" }) ledger.Rejected++;
        return loaded;
    }

    private async ValueTask<JobStep> RunAsync(ProgramChunk chunk)
    {
        var progress = new ChunkProgress(chunk, _path.Count);
        if (await machine.OpenAsync(ledger.SegmentsBefore + _path.Count, progress.SequenceStarts, 0).ConfigureAwait(false) is { Ends: true } unopened) return unopened;
        machine.PlaceInProgram = progress.PlaceOf;
        machine.Tool.WantedByProgram = ChunkProgress.IsToolWanted;
        if (await machine.SendAllAsync(StartCommands()).ConfigureAwait(false) is { Ends: true } unstarted) return unstarted;
        _chunk = progress;
        machine.SegmentsDone = state => ledger.SegmentsBefore + progress.Executed(state.Calls, state.SequenceRunning ? state.Counter : 0);
        (_sequences, _borne) = ([.. chunk.Parts.SelectMany(part => part.Sequences)], -1);
        BearFrom(0);
        machine.Hold.RapidsAreAsPlanned();
        machine.Hold.HasProgramEnded = state => progress.IsEnd(state.Calls);
        ledger.Sent += chunk.Segments.Count();
        try
        {
            if (await machine.AwaitWatchdogAsync().ConfigureAwait(false) is { Ends: true } unwatched) return unwatched;
            if (machine.Tool.HasSpindle && await TurnAsync().ConfigureAwait(false) is { Ends: true } unturned) return unturned;
            var end = await WatchedAsync(chunk).ConfigureAwait(false);
            return end.Ends && machine.State.ProgramError == SupervisedProgram.Strayed ? end with { Sentence = end.Sentence + progress.PlaceAt(machine.State.Calls) } : end;
        }
        finally
        {
            machine.Expectation = null;
            machine.Feed.Planned = null;
            machine.Hold.HasProgramEnded = null;
            machine.SegmentsDone = null;
        }
    }

    private IReadOnlyList<string> StartCommands() =>
    [
        ResidentServer.DefineVariables(machine.Profile),
        ResidentServer.MarkCommand(machine.Mark),
        .. ResidentServer.DefineHeight(machine.Profile, machine.Frame, machine.Lift, isCut: true),
        .. machine.Tool.HasSpindle ? (string[])[ResidentServer.CloseGateCommand] : [],
        Text($"XQ {SupervisedProgram.Entry},{ResidentProgram.MainThread}"),
    ];

    /// <summary>Spindle on while the program waits behind its first rapid, and the gate open when it has its speed, whether or not the job was held
    /// meanwhile.</summary>
    private async ValueTask<JobStep> TurnAsync()
    {
        machine.Hold.KeepsGate = true;
        try
        {
            if (await machine.AwaitAsync(ResidentProgram.Variables.AtGate, waits => waits != 0.0).ConfigureAwait(false) is { Ends: true } astray) return astray;
            if (await machine.Tool.TurnForProgramAsync().ConfigureAwait(false) is { Ends: true } standing) return standing;
        }
        finally
        {
            machine.Hold.KeepsGate = false;
        }

        return await machine.SendAsync(ResidentServer.OpenGateCommand).ConfigureAwait(false);
    }

    /// <summary>The program was read back before it ran; the path is watched all the same, because somebody else may move the axes. Over a serial line
    /// sequence and position are queried one after the other, and only the end is compared.</summary>
    private async ValueTask<JobStep> WatchedAsync(ProgramChunk chunk)
    {
        var watches = chunk.Parts.SelectMany(part => part.Sequences).Select(sequence => machine.Watch(sequence.Start, sequence.Segments, sequence.Speed)).ToList();
        if (machine.Line is null) machine.Expectation = state => IsCutting(state) && state.Calls / 2 < watches.Count ? watches[state.Calls / 2].Look(state.Counter, machine.Here) : JobStep.Done;
        if (_sequences.Count > 0) machine.Feed.Planned = PlannedSpeeds();
        var end = await machine.PollUntilAsync(IsDone, Seconds(chunk)).ConfigureAwait(false);
        return end.Ends || watches.Count == 0 ? end : watches[^1].LookAtEnd(machine.Here with { Z = chunk.Parts[^1].Sequences[^1].End.Z }); // a tool that an axis holds is up again by now
    }

    /// <summary>Over a network the speed belongs to seq, which is read with it; on a serial line seq is read earlier, and the speed may be that of any
    /// sequence of the chunk.</summary>
    private Func<MachineState, PlannedSpeed?> PlannedSpeeds()
    {
        if (machine.Line is null) return state => IsCutting(state) && state.Calls / 2 < _sequences.Count ? PlannedSpeed.Of(_sequences[state.Calls / 2].Speed) : null;
        var any = new PlannedSpeed(_sequences.Min(sequence => sequence.Speed), _sequences.Max(sequence => sequence.Speed));
        return _ => any;
    }

    /// <summary>The controller is at this sequence: it and those that may come before the next look must bear the override.</summary>
    private void BearFrom(int sequence)
    {
        if (sequence == _borne || sequence >= _sequences.Count) return;
        _borne = sequence;
        var (ahead, seconds) = (new List<VectorSequence>(), 0.0);
        for (var i = sequence; i < _sequences.Count && (i == sequence || seconds < SecondsAhead); i++)
        {
            ahead.Add(_sequences[i]);
            if (i > sequence) seconds += SpeedTrapezoid.Time(_sequences[i].Length, _sequences[i].Speed * JobControl.FeedRange.Fastest, program.Profile.AccelerationCounts);
        }

        machine.Hold.Speed.Bear(machine.Profile, ahead, hostFeeds: false);
    }

    /// <summary>Shortest time of the chunk, seconds: the motion of its sequences, without rapids and settle times.</summary>
    private double Seconds(ProgramChunk chunk) => chunk.Parts.SelectMany(part => part.Sequences).Sum(sequence => SpeedTrapezoid.Time(sequence.Length, sequence.Speed, program.Profile.AccelerationCounts));

    /// <summary>True while a sequence is being cut, which has an odd mark.</summary>
    private static bool IsCutting(MachineState state) => state.SequenceRunning && state.Calls % 2 != 0;

    private bool IsDone(MachineState state)
    {
        BearFrom(state.Calls / 2);
        _path.ConfirmUpTo(_chunk!.Executed(state.Calls, state.SequenceRunning ? state.Counter : 0));
        return _chunk.IsEnd(state.Calls);
    }
}
