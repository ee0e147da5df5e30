using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Runs the job in the controller, one chunk after another; the next one is loaded while the machine is at rest with the tool off
/// (galil-dmc.md F.1 method 2).</summary>
/// <remarks>
/// While a program is loaded no thread watches the machine, so a spindle is off meanwhile; it is switched on once the program waits after its first rapid,
/// with its watchdog running.
/// No operand reports how many lines the program memory holds (galil-dmc.md 0.3: 1000, not confirmed), so the download itself tests it: when it is refused
/// for too many lines, the rest of the job is packed for half as many.
/// </remarks>
internal sealed class ProgramStrategy(MotionProgram program, JobMachine machine, JobLedger ledger, JobLog log, ControllerProgramMemory memory, JobOptions options) : IJobStrategy
{
    /// <summary>The override is limited to what the sequences allow that may be run before it can be changed again, seconds at the fastest
    /// override.</summary>
    private const double SecondsAhead = 1.5;

    private readonly ExecutedPath _path = new(program, machine, ledger, log);
    private int _memoryLines = DmcLimits.ProgramLines;
    private ChunkProgress? _chunk;
    private IReadOnlyList<VectorSequence> _sequences = [];
    private int _limitedFrom = -1;

    public Phase Whole => Phase.Idle with { TurnsForPrograms = true };

    public ValueTask StartAsync() => ValueTask.CompletedTask;

    public async ValueTask CutAsync()
    {
        if (program.Strokes.Count == 0) return;
        var job = new SupervisedProgram(program, machine.Frame.ToController, options.DryRun);
        var waiting = Packed(job, program.Strokes);
        while (waiting.TryPeek(out var chunk))
        {
            await machine.Hold.GateAsync().ConfigureAwait(false);
            if (await LoadAsync(chunk).ConfigureAwait(false) is not { } refused)
            {
                waiting.Dequeue();
                await RunAsync(chunk).ConfigureAwait(false);
            }
            else if (refused is { Code: TcCode.DownloadError, Command: "DL" } && _memoryLines / 2 >= job.MinLines) // too long
            {
                _memoryLines /= 2;
                waiting = Packed(job, [.. waiting.SelectMany(later => later.Parts)]);
            }
            else
            {
                if (refused.Command == "DL") ledger.Rejected++;
                throw JobEnd.Refused(refused, "").ToException();
            }
        }
    }

    public async ValueTask StoppedAsync(int counter)
    {
        if (_chunk is null || await machine.Commands.AskAtRestAsync(ResidentProgram.Variables.Sequence).ConfigureAwait(false) is not { } mark) return;
        _path.ConfirmUpTo(_chunk.Executed((int)mark, counter));
    }

    private Queue<ProgramChunk> Packed(SupervisedProgram job, IReadOnlyList<MotionStroke> strokes)
    {
        var packed = job.Pack(strokes, _memoryLines, options.SourceOf);
        if (_path.Count == 0) ledger.Diagnostics.Clear();
        ledger.Diagnostics.AddRange(packed.Diagnostics);
        return new Queue<ProgramChunk>(packed.Chunks);
    }

    /// <summary>No thread may run while the memory changes; the watchdog is stopped too, while the machine is at rest and its spindle is off.</summary>
    /// <returns>The rejection of the program; null when it is in the memory.</returns>
    private async ValueTask<Rejected?> LoadAsync(ProgramChunk chunk)
    {
        _chunk = null;
        await machine.Tool.TurnAsync(on: false).ConfigureAwait(false);
        await machine.HaltProgramAsync().ConfigureAwait(false);
        return await memory.SwapAsync(chunk.Text, machine.Stop).ConfigureAwait(false);
    }

    private async ValueTask RunAsync(ProgramChunk chunk)
    {
        var progress = new ChunkProgress(chunk, _path.Count);
        await machine.OpenAsync(ledger.SegmentsBefore + _path.Count, progress.SequenceStarts, 0).ConfigureAwait(false);
        using var running = machine.Enter(machine.Phase with
        {
            Program = progress,
            SegmentsDone = state => ledger.SegmentsBefore + progress.Executed(state.Calls, state.SequenceRunning ? state.Counter : 0),
        });
        await machine.Commands.SendAllAsync(StartCommands()).ConfigureAwait(false);
        _chunk = progress;
        (_sequences, _limitedFrom) = ([.. chunk.Parts.SelectMany(part => part.Sequences)], -1);
        LimitFrom(0);
        machine.Speed.RapidsAreAsPlanned();
        ledger.Sent += chunk.Segments.Count();
        await machine.AwaitWatchdogAsync().ConfigureAwait(false);
        if (machine.Tool.HasSpindle) await TurnAsync().ConfigureAwait(false);
        await WatchAsync(chunk, progress).ConfigureAwait(false);
    }

    private IReadOnlyList<string> StartCommands() =>
    [
        ResidentServer.DefineVariables(machine.Profile, program.LongestWait),
        ResidentServer.MarkCommand(machine.Mark),
        .. ResidentServer.DefineHeight(machine.Profile, machine.Frame.Origin, machine.Frame.Lift, isCut: true),
        .. machine.Tool.HasSpindle ? (string[])[ResidentServer.CloseGateCommand] : [],
        DmcFormat.Text($"XQ {SupervisedProgram.Entry},{ResidentProgram.MainThread}"),
    ];

    /// <summary>Spindle on while the program waits after its first rapid, and the gate open when it has its speed, whether or not the job was held
    /// meanwhile.</summary>
    private async ValueTask TurnAsync()
    {
        using (machine.Enter(machine.Phase with { KeepsGate = true }))
        {
            await machine.AwaitAsync(ResidentProgram.Variables.AtGate, waits => waits != 0.0).ConfigureAwait(false);
            await machine.Tool.TurnForProgramAsync().ConfigureAwait(false);
        }

        await machine.Commands.SendAsync(ResidentServer.OpenGateCommand).ConfigureAwait(false);
    }

    /// <summary>The program was read back before it ran; the path is watched all the same, because another host may move the axes. Over a serial line
    /// sequence and position are queried one after the other, and only the end is compared.</summary>
    private async ValueTask WatchAsync(ProgramChunk chunk, ChunkProgress progress)
    {
        var watches = _sequences.Select(sequence => machine.WatchPath(sequence.Start, sequence.Segments, sequence.Speed)).ToList();
        using var cutting = machine.Enter(machine.Phase with
        {
            Expected = machine.Line is null ? state => IsCutting(state) && state.Calls / 2 < watches.Count ? watches[state.Calls / 2].Check(state.Counter, machine.Here) : null : null,
            Speed = _sequences.Count > 0 ? SpeedOfPoll() : null,
            Place = state => progress.PlaceAt(state.Calls),
        });
        await machine.PollUntilAsync(IsDone, Seconds(chunk)).ConfigureAwait(false);
        if (watches.Count > 0 && watches[^1].LookAtEnd(machine.Here with { Z = _sequences[^1].End.Z }) is { } elsewhere) throw elsewhere.ToException(); // a tool that an axis drives is up again by now
    }

    /// <summary>Over a network the speed belongs to seq, which is read with it; on a serial line seq is read earlier, and the speed may be that of any
    /// sequence of the chunk.</summary>
    private Func<JobPoll, PlannedSpeed?> SpeedOfPoll()
    {
        var any = PlannedSpeed.Anywhere(_sequences, program.Profile);
        if (machine.Line is not null) return _ => any;
        var (at, planned) = (-1, default(PlannedSpeeds));
        return state =>
        {
            var sequence = state.Calls / 2;
            if (!IsCutting(state) || sequence >= _sequences.Count) return null;
            if (sequence != at) (at, planned) = (sequence, new PlannedSpeeds(_sequences[sequence], program.Profile));
            return planned!.At(state.Counter);
        };
    }

    /// <summary>The controller is at this sequence: the override is limited to what it allows, and what those allow that may come before the next
    /// poll.</summary>
    private void LimitFrom(int sequence)
    {
        if (sequence == _limitedFrom || sequence >= _sequences.Count) return;
        _limitedFrom = sequence;
        var (ahead, seconds) = (new List<VectorSequence>(), 0.0);
        for (var i = sequence; i < _sequences.Count && (i == sequence || seconds < SecondsAhead); i++)
        {
            ahead.Add(_sequences[i]);
            if (i > sequence) seconds += SequenceProfile.SecondsOf(_sequences[i], program.Profile);
        }

        machine.Speed.LimitBy(ahead, hostFeeds: false);
    }

    /// <summary>Shortest time of the chunk, seconds: the motion of its sequences, without rapids and settle times.</summary>
    private double Seconds(ProgramChunk chunk) => chunk.Parts.SelectMany(part => part.Sequences).Sum(sequence => SequenceProfile.SecondsOf(sequence, program.Profile));

    /// <summary>True while a sequence is being cut, which has an odd mark.</summary>
    private static bool IsCutting(JobPoll state) => state.SequenceRunning && state.Calls % 2 != 0;

    private bool IsDone(JobPoll state)
    {
        LimitFrom(state.Calls / 2);
        _path.ConfirmUpTo(_chunk!.Executed(state.Calls, state.SequenceRunning ? state.Counter : 0));
        return _chunk.IsEnd(state.Calls);
    }
}
