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

/// <summary>Replays the recorded bytes of a run at the same times to a separate simulated controller. It moves as the machine did, sample for sample if the
/// machine was simulated too. Events at the machine itself (a jammed axis, an active switch) are not replayed.</summary>
public sealed class IncidentReplay : IAsyncDisposable
{
    /// <summary>Maximum time that the controller continues after an interrupted recording, and maximum time at rest.</summary>
    private static readonly TimeSpan s_maxDuration = TimeSpan.FromMinutes(10);
    private static readonly TimeSpan s_maxSettleTime = TimeSpan.FromSeconds(10);

    /// <summary>Simulator steps between two checks for cancellation.</summary>
    private const int SliceSteps = 20_000;

    private readonly SimulatedController _controller;
    private readonly Dictionary<int, Stream> _links = [];

    private IncidentReplay(Conversation conversation, InterruptedJob? job)
    {
        (Conversation, JournalledJob) = (conversation, job);
        var options = new SimulatorOptions { Speed = double.PositiveInfinity, Time = new FrozenTimeProvider(), SerialNumber = MachineConnection.SimulatedSerialNumber };
        _controller = new SimulatedController(conversation.Clock == ConversationClock.RealTime ? options with { CommandCost = TimeSpan.Zero } : options);
    }

    /// <summary>The run in the journal: its header and, if it ended regularly, its end; null if the journal has no job.</summary>
    public InterruptedJob? JournalledJob { get; }

    /// <summary>The recorded conversation.</summary>
    public Conversation Conversation { get; }

    /// <summary>Maximum delay of a line in the replay relative to the host, seconds: 0 for a simulated machine, some milliseconds if the real controller
    /// answered faster than the simulated one.</summary>
    public double LateSeconds { get; private set; }

    /// <summary>Number of samples with motion or changed outputs.</summary>
    public int Samples => _controller.Record.Count;

    /// <summary>Controller time of the last sample, seconds.</summary>
    public double Seconds => Samples > 0 ? _controller.Record[Samples - 1].Seconds : 0.0;

    /// <summary>Final position of the job's axes, counts of the controller; null if nothing moved.</summary>
    public CountsPoint? FinalPosition => Samples == 0 ? null : new CountsPoint(At(0), At(1), Letters.Length > 2 ? At(2) : 0);

    /// <summary>Whether the final position matches the journal; null if the journal has none or nothing moved.</summary>
    public bool? EndsAsJournalled => JournalledJob?.End is { X: { } x, Y: { } y } && FinalPosition is { } found ? (x, y) == (found.X, found.Y) : null;

    /// <summary>The letters of the job's axes; older journals do not contain them.</summary>
    private string Letters => JournalledJob?.Header.Axes is { Length: > 0 } letters ? letters : MachineAxes.Default.Letters;

    /// <summary>Replays the last run of a journal.</summary>
    /// <param name="wire">The conversation beside it.</param>
    /// <returns>The replay, or which data is missing, without a full stop.</returns>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static async Task<(IncidentReplay? Replay, string? Lack)> RunAsync(string journal, string wire, CancellationToken cancellation)
    {
        IncidentReplay replay;
        try
        {
            var job = InterruptedJob.Read(journal);
            if (!File.Exists(wire)) return (null, Wording.Get("Replay.NoRecordedCommands", journal, wire));
            using var input = CompressedText.Open(wire);
            if (job?.Header.Axes is { Length: > 0 } axes && (axes.Length is not (2 or 3) || !axes.All(letter => letter is >= 'A' and <= 'D'))) throw new FormatException(Wording.Get("Replay.InvalidAxes", axes));
            replay = new IncidentReplay(Conversation.Read(input), job);
        }
        catch (Exception unusable) when (unusable is IOException or UnauthorizedAccessException or FormatException)
        {
            return (null, Wording.Get("Replay.Unreadable", SystemErrorText.WithPath(unusable)));
        }

        try
        {
            await replay.SendAsync(cancellation).ConfigureAwait(false);
        }
        catch (IOException refused)
        {
            await replay.DisposeAsync().ConfigureAwait(false); // More links than a controller has.
            return (null, Wording.Get("Replay.Unreadable", SystemErrorText.WithPath(refused)));
        }

        replay.SettleAxes(cancellation);
        return (replay, null);
    }

    /// <summary>Writes the samples in the format of <c>simulate --record</c>.</summary>
    public void WriteRecord(TextWriter output) => _controller.Record.WriteCsv(output);

    /// <summary>Compares the samples with a record line by line.</summary>
    /// <returns>The number of matching lines and the first differing line of both; null for the one that ends earlier, or if nothing differs.</returns>
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

    private async Task SendAsync(CancellationToken cancellation)
    {
        using var clock = _controller.JoinClock();
        if (JournalledJob?.Header is { } header && (header.StartX, header.StartY, header.StartZ) != (0, 0, 0)) await SetPositionAsync(header).ConfigureAwait(false);
        foreach (var step in Conversation.Steps)
        {
            cancellation.ThrowIfCancellationRequested();
            await AdvanceToAsync(clock, step.Ticks).ConfigureAwait(false);
            LateSeconds = Math.Max(LateSeconds, TimeSpan.FromTicks(clock.GetTimestamp() - step.Ticks).TotalSeconds);
            await ExecuteAsync(step).ConfigureAwait(false);
        }
    }

    /// <summary>Sets the start position from the journal, if the machine had been moved before.</summary>
    private async Task SetPositionAsync(JournalHeader header)
    {
        await using var link = _controller.OpenConnection();
        long[] places = [header.StartX, header.StartY, header.StartZ];
        for (var axis = 0; axis < Letters.Length; axis++) await link.WriteAsync(DmcAxes.Placing(Letters[axis], places[axis])).ConfigureAwait(false);
    }

    private async Task ExecuteAsync(ConversationStep step)
    {
        switch (step.Event)
        {
            case ConversationEvent.Opened:
                _links[step.Link] = _controller.OpenConnection();
                break;
            case ConversationEvent.Said when _links.GetValueOrDefault(step.Link) is { } link:
                await SendAsync(link, step.Bytes).ConfigureAwait(false);
                break;
            case ConversationEvent.Closed when _links.Remove(step.Link, out var closed):
                await closed.DisposeAsync().ConfigureAwait(false);
                break;
        }
    }

    private static async Task SendAsync(Stream link, byte[] bytes)
    {
        try
        {
            await link.WriteAsync(bytes).ConfigureAwait(false);
        }
        catch (IOException)
        {
            // The controller has closed this link (a reset): what the host sent then was lost too.
        }
    }

    /// <summary>Advances controller time to a moment.</summary>
    private static async Task AdvanceToAsync(HostClock clock, long ticks)
    {
        var left = ticks - clock.GetTimestamp();
        if (left <= 0) return;
        var reached = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        await using var timer = clock.CreateTimer(_ => reached.TrySetResult(), null, TimeSpan.FromTicks(left), Timeout.InfiniteTimeSpan);
        await reached.Task.ConfigureAwait(false);
    }

    /// <summary>Simulates what the controller still does on its own: its watchdog detects the missing host.</summary>
    private void SettleAxes(CancellationToken cancellation)
    {
        var end = _controller.Status.Sample + s_maxDuration.TotalMilliseconds;
        while (true)
        {
            cancellation.ThrowIfCancellationRequested();
            var (status, hasRested) = _controller.AdvanceToRest(s_maxDuration, s_maxSettleTime, SliceSteps);
            if (status.IsIdle || hasRested || status.Sample >= end) return;
        }
    }
}
