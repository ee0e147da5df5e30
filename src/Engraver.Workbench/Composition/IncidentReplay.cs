using System.Text;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Language;
using Engraver.Links.Recording;
using Engraver.Simulator;
using Engraver.Simulator.Clocks;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Composition;

/// <summary>A run that was kept, said again byte by byte and at the same times to a simulated controller of its own: it moves as the machine did, sample
/// for sample where the machine was a simulated one too. What happened to the machine itself (a jammed axis, a pressed switch) is not said and not
/// repeated.</summary>
public sealed class IncidentReplay : IAsyncDisposable
{
    /// <summary>After a conversation that broke off, the controller goes on for at most this long, and for this long at rest.</summary>
    private static readonly TimeSpan s_longest = TimeSpan.FromMinutes(10);
    private static readonly TimeSpan s_longestRest = TimeSpan.FromSeconds(10);

    /// <summary>Steps of the simulator between two looks at the cancellation.</summary>
    private const int SliceSteps = 20_000;

    private readonly SimulatedController _controller;
    private readonly Dictionary<int, Stream> _links = [];

    private IncidentReplay(Conversation conversation, InterruptedJob? told)
    {
        (Conversation, Told) = (conversation, told);
        var options = new SimulatorOptions { Speed = double.PositiveInfinity, Time = new StandingTime(), SerialNumber = MachineConnection.SimulatedSerialNumber };
        _controller = new SimulatedController(conversation.Clock == ConversationClock.RealTime ? options with { CommandCost = TimeSpan.Zero } : options);
    }

    /// <summary>What the journal tells of the run: its header and, where it ended in order, how; null where it tells of no job.</summary>
    public InterruptedJob? Told { get; }

    /// <summary>What was said.</summary>
    public Conversation Conversation { get; }

    /// <summary>By how much the replay came later with a line than the host did, at most, seconds: 0 with a simulated machine, some milliseconds where the
    /// real controller answered faster than the simulated one does.</summary>
    public double LateSeconds { get; private set; }

    /// <summary>Rows of motion and of changed outputs.</summary>
    public int Samples => _controller.Record.Count;

    /// <summary>Controller time of the last of them, seconds.</summary>
    public double Seconds => Samples > 0 ? _controller.Record[Samples - 1].Seconds : 0.0;

    /// <summary>Where the axes of the job came to rest, counts of the controller; null when nothing moved.</summary>
    public CountsPoint? FinalPosition => Samples == 0 ? null : new CountsPoint(At(0), At(1), Letters.Length > 2 ? At(2) : 0);

    /// <summary>Whether it came to rest where the journal says; null where the journal does not say it, or nothing moved.</summary>
    public bool? Agrees => Told?.End is { X: { } x, Y: { } y } && FinalPosition is { } found ? (x, y) == (found.X, found.Y) : null;

    /// <summary>The letters of the job's axes; older journals do not tell them.</summary>
    private string Letters => Told?.Header.Axes is { Length: > 0 } letters ? letters : MachineAxes.Default.Letters;

    /// <summary>Replays the last run of a journal.</summary>
    /// <param name="wire">The conversation beside it.</param>
    /// <returns>The replay, or what is lacking, without a full stop.</returns>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static async Task<(IncidentReplay? Replay, string? Lack)> RunAsync(string journal, string wire, CancellationToken cancellation)
    {
        IncidentReplay replay;
        try
        {
            var told = InterruptedJob.Read(journal);
            if (!File.Exists(wire)) return (null, Wording.Get("Replay.NoRecordedCommands", journal, wire));
            using var input = CompressedText.Open(wire);
            if (told?.Header.Axes is { Length: > 0 } axes && (axes.Length is not (2 or 3) || !axes.All(letter => letter is >= 'A' and <= 'D'))) throw new FormatException(Wording.Get("Replay.InvalidAxes", axes));
            replay = new IncidentReplay(Conversation.Read(input), told);
        }
        catch (Exception unusable) when (unusable is IOException or UnauthorizedAccessException or FormatException)
        {
            return (null, Wording.Get("Replay.Unreadable", SystemReason.WithPath(unusable)));
        }

        try
        {
            await replay.SayAsync(cancellation).ConfigureAwait(false);
        }
        catch (IOException refused)
        {
            await replay.DisposeAsync().ConfigureAwait(false); // more links than a controller has
            return (null, Wording.Get("Replay.Unreadable", SystemReason.WithPath(refused)));
        }

        replay.ComeToRest(cancellation);
        return (replay, null);
    }

    /// <summary>Writes the samples as <c>simulate --record</c> does.</summary>
    public void WriteRecord(TextWriter output) => _controller.Record.WriteCsv(output);

    /// <summary>Holds the samples against a record, line by line.</summary>
    /// <returns>How many lines are the same, and the first one that is not, from 1, as it is there and here; null where one of the two only ends earlier
    /// (its own is empty then) or none differs.</returns>
    public ReplayComparison CompareWith(TextReader record)
    {
        ArgumentNullException.ThrowIfNull(record);
        var text = new StringBuilder();
        using (var writer = new StringWriter(text)) WriteRecord(writer);
        using var replayed = new StringReader(text.ToString());
        for (var line = 0; ; line++)
        {
            var (there, here) = (record.ReadLine(), replayed.ReadLine());
            if (there is null && here is null) return new ReplayComparison(line, null, null);
            if (there != here) return new ReplayComparison(line, there, here);
        }
    }

    public async ValueTask DisposeAsync()
    {
        foreach (var link in _links.Values) await link.DisposeAsync().ConfigureAwait(false);
        await _controller.DisposeAsync().ConfigureAwait(false);
    }

    private int At(int axis) => _controller.Record[Samples - 1][Letters[axis] - 'A'];

    private async Task SayAsync(CancellationToken cancellation)
    {
        using var clock = _controller.JoinClock();
        if (Told?.Header is { } header && (header.StartX, header.StartY, header.StartZ) != (0, 0, 0)) await PlaceAsync(header).ConfigureAwait(false);
        foreach (var step in Conversation.Steps)
        {
            cancellation.ThrowIfCancellationRequested();
            await UntilAsync(clock, step.Ticks).ConfigureAwait(false);
            LateSeconds = Math.Max(LateSeconds, TimeSpan.FromTicks(clock.GetTimestamp() - step.Ticks).TotalSeconds);
            await DoAsync(step).ConfigureAwait(false);
        }
    }

    /// <summary>A machine that had been moved before counts from where the journal says that it stood.</summary>
    private async Task PlaceAsync(JournalHeader header)
    {
        await using var link = _controller.OpenConnection();
        long[] places = [header.StartX, header.StartY, header.StartZ];
        for (var axis = 0; axis < Letters.Length; axis++) await link.WriteAsync(DmcAxes.Placing(Letters[axis], places[axis])).ConfigureAwait(false);
    }

    private async Task DoAsync(ConversationStep step)
    {
        switch (step.Act)
        {
            case ConversationAct.Opened:
                _links[step.Link] = _controller.OpenConnection();
                break;
            case ConversationAct.Said when _links.GetValueOrDefault(step.Link) is { } link:
                await SayAsync(link, step.Bytes).ConfigureAwait(false);
                break;
            case ConversationAct.Closed when _links.Remove(step.Link, out var closed):
                await closed.DisposeAsync().ConfigureAwait(false);
                break;
        }
    }

    private static async Task SayAsync(Stream link, byte[] bytes)
    {
        try
        {
            await link.WriteAsync(bytes).ConfigureAwait(false);
        }
        catch (IOException)
        {
            // The controller has closed this link (a reset): what the host said then, it said to nobody either.
        }
    }

    /// <summary>Lets controller time pass up to a moment.</summary>
    private static async Task UntilAsync(HostClock clock, long ticks)
    {
        var left = ticks - clock.GetTimestamp();
        if (left <= 0) return;
        var reached = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        await using var timer = clock.CreateTimer(_ => reached.TrySetResult(), null, TimeSpan.FromTicks(left), Timeout.InfiniteTimeSpan);
        await reached.Task.ConfigureAwait(false);
    }

    /// <summary>What the controller still does by itself: a host that is gone is noticed by its watchdog.</summary>
    private void ComeToRest(CancellationToken cancellation)
    {
        var end = _controller.Status.Sample + s_longest.TotalMilliseconds;
        while (true)
        {
            cancellation.ThrowIfCancellationRequested();
            var (status, hasRested) = _controller.AdvanceToRest(s_longest, s_longestRest, SliceSteps);
            if (status.IsIdle || hasRested || status.Sample >= end) return;
        }
    }
}

/// <summary>How a replay and a record agree.</summary>
/// <param name="Same">Lines from the beginning that are the same, the heading included.</param>
/// <param name="There">The first other line of the record; null where it has ended, or nothing differs.</param>
/// <param name="Here">The same of the replay.</param>
public sealed record ReplayComparison(int Same, string? There, string? Here)
{
    public bool IsSame => There is null && Here is null;
}
