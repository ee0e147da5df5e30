using System.Text;
using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Galil.Protocol;

/// <summary>The bytes of one link: writes lines, downloads and urgent lines, reads the frames of their replies, and compares echoes.</summary>
/// <remarks>One exchange at a time, which <see cref="CommandChannel"/> ensures; only <see cref="UrgeAsync"/> may come at any time from any thread.</remarks>
internal sealed class CommandWire : IAsyncDisposable
{
    /// <summary>Longest reply to a command, bytes, for its time-out on a serial line.</summary>
    private const int MaxCommandReply = 512;

    /// <summary>Bytes of each portion of a download over a serial line, so that it can be cancelled between them.</summary>
    private const int DownloadPortion = 128;

    private readonly IControllerLink _link;
    private readonly string _name;
    private readonly TimeSpan _replyTimeout;
    private readonly IWireTrace? _trace;
    private readonly ReplyDeadline _deadline;
    private readonly ReplyFramer _framer;
    private readonly SemaphoreSlim _writing = new(1, 1);
    private readonly byte[] _received = new byte[4096];
    private byte[] _sent = new byte[256];
    private TimeSpan _timeout;
    private ControllerException? _failure;
    private LineEcho? _echo;

    /// <summary>What is on the wire and not completely answered; set by the holder of <see cref="_writing"/>.</summary>
    private volatile Exchange _underWay = Exchange.None;

    /// <summary>Prompts of urgent lines that were not taken yet; changed by the holder of <see cref="_writing"/>.</summary>
    private int _owed;

    /// <summary>The echo of an urgent line could not be separated from an answer: from then on the stop waits for its turn.</summary>
    private volatile bool _echoesMix;

    private enum Exchange
    {
        None,
        Command,

        /// <summary>A download, an upload or a record: on a serial line its bytes cannot be separated from those of another line.</summary>
        Transfer,
    }

    /// <param name="link">Owned: closed with this.</param>
    /// <param name="name">The handle's name in the trace.</param>
    public CommandWire(IControllerLink link, string name, TimeSpan replyTimeout, TimeProvider time, IWireTrace? trace)
    {
        _link = link;
        _name = name;
        _replyTimeout = replyTimeout;
        _trace = trace;
        _deadline = new ReplyDeadline(time);
        _framer = new ReplyFramer { MessageReceived = OnMessage };
    }

    public string Description => _link.Description;

    /// <summary>The first failure; null while there is none.</summary>
    public ControllerException? Failure => _failure;

    /// <summary>Null for a link that is not a serial line.</summary>
    public SerialLine? Line => _link.Line;

    /// <summary>Total time from the first byte of each exchange to the end of its answer.</summary>
    public TimeSpan Busy => _deadline.Busy;

    /// <summary>Every command is compared with its echo.</summary>
    public bool ComparesEcho => _echo is not null;

    /// <summary>Called with each line that a program in the controller printed.</summary>
    public Action<string>? MessageReceived { get; set; }

    /// <summary>From here on every command is compared with its echo.</summary>
    /// <param name="hasLineEnd">The end of a line is echoed.</param>
    public void CompareEcho(bool hasLineEnd) => _echo = new LineEcho(hasLineEnd);

    /// <summary>The exchange has ended: its time-out no longer applies.</summary>
    public void EndExchange()
    {
        _deadline.Stop();
        _underWay = Exchange.None;
    }

    /// <param name="prompts">Those that may come before the end of the echo.</param>
    /// <returns>True when a download was ended early.</returns>
    public async ValueTask<bool> WriteAsync(string text, bool isDownload, ReplyShape shape, int recordLength, TimeSpan timeout, CancellationToken cancellation, EarlyPrompts prompts = default)
    {
        await WritingAsync(text).ConfigureAwait(false);
        try
        {
            if (!isDownload || Line is null) await PutAsync(text, shape, recordLength, timeout, prompts).ConfigureAwait(false);
            else return await WriteInPortionsAsync(Begin(text, shape, recordLength, timeout), text, cancellation).ConfigureAwait(false);
            return false;
        }
        finally
        {
            _writing.Release();
        }
    }

    /// <summary>Puts a line of commands on the wire at once, also while another command waits for its answer, which may be late or lost; the prompts of the
    /// urgent line are taken before the next command goes out (<see cref="CommandChannel.SendUrgentAsync"/>).</summary>
    /// <param name="isFree">No command waits for its answer.</param>
    public async ValueTask UrgeAsync(string text, bool isFree)
    {
        if (_echoesMix || (Line is null && isFree)) return;
        await _writing.WaitAsync().ConfigureAwait(false);
        try
        {
            if (_failure is not null || (Line is not null && _underWay == Exchange.Transfer)) return;
            _trace?.Write(_name, '>', text);
            var bytes = Encoding.Latin1.GetBytes(text + "\r");
            if (_underWay == Exchange.None && _owed == 0) Expect(ReplyShape.Text, 0, isDownload: false);
            _owed += CommandLine.Parts(text).Count;
            _echo?.SentUrgently(bytes);
            await _link.WriteAsync(bytes, _deadline.Expired).ConfigureAwait(false);
        }
        catch (Exception failure) when (failure is IOException or ObjectDisposedException or OperationCanceledException)
        {
            Fail(Describe(failure, text));
        }
        finally
        {
            _writing.Release();
        }
    }

    /// <summary>Takes the prompts of urgent lines, so that later ones belong to the next line, and keeps the right to write until that line is out.</summary>
    private async ValueTask WritingAsync(string text)
    {
        await _writing.WaitAsync().ConfigureAwait(false);
        if (_owed == 0) return;
        try
        {
            _deadline.Start(_replyTimeout + WireTime(MaxCommandReply));
            for (; _owed > 0; _owed--)
            {
                if (await TryReadFrameAsync(text).ConfigureAwait(false) is null) await GreetAgainAsync().ConfigureAwait(false);
            }
        }
        catch (ControllerException)
        {
            _writing.Release();
            throw;
        }
    }

    /// <summary>The echo of an urgent line cannot be separated from an answer: ends a half line and begins to compare again. The caller holds
    /// <see cref="_writing"/>.</summary>
    private async ValueTask GreetAgainAsync()
    {
        _echoesMix = true;
        (var compares, _echo, _owed) = (_echo, null, 1); // the answer to the greeting is behind the prompts of every urgent line
        foreach (var (text, shape) in new[] { (EchoHandshake.Text, ReplyShape.Greeting), ("EO 1", ReplyShape.Text) })
        {
            await PutAsync(text, shape, 0, _replyTimeout).ConfigureAwait(false);
            await TryReadFrameAsync(text).ConfigureAwait(false);
        }

        _echo = compares;
        _echo?.Begin(false);
    }

    /// <summary>The answer to this command is mixed with the echo of an urgent line: a question is sent again.</summary>
    /// <exception cref="EchoException">The text is a command, which is answered by a prompt alone: the urgent line was damaged, and whether the command was
    /// executed is not known.</exception>
    public async ValueTask AskAgainAsync(string text)
    {
        var heard = _echo!.UrgentDifference!;
        await _writing.WaitAsync().ConfigureAwait(false);
        try
        {
            await GreetAgainAsync().ConfigureAwait(false);
            _owed = 0;
        }
        finally
        {
            _writing.Release();
        }

        if (!text.StartsWith("MG ", StringComparison.Ordinal)) throw Harmed(text, heard);
        await WriteAsync(text, false, ReplyShape.Text, 0, _replyTimeout, CancellationToken.None).ConfigureAwait(false);
    }

    /// <summary>After a wrong echo it is not known what the controller executed, but the stop must still reach it: the line is greeted again, which ends
    /// any half command, and continues without echoes.</summary>
    private async ValueTask<EchoException> HarmedAsync(string text, string heard)
    {
        await _writing.WaitAsync().ConfigureAwait(false);
        try
        {
            (_echo, _owed) = (null, 0); // the answer to the greeting is behind the prompts of every urgent line
            await PutAsync(EchoHandshake.Text, ReplyShape.Greeting, 0, _replyTimeout).ConfigureAwait(false);
        }
        finally
        {
            _writing.Release();
        }

        await TryReadFrameAsync(EchoHandshake.Text).ConfigureAwait(false);
        return Harmed(text, heard);
    }

    private EchoException Harmed(string text, string heard) => new(Wording.Get("CommandChannel.EchoDiffers", _link.Description, heard.TrimEnd('\r'), FirstLine(text)));

    public async ValueTask DisposeAsync()
    {
        _failure ??= new ControllerLinkException(Wording.Get("CommandChannel.LinkClosed", _link.Description));
        await _link.DisposeAsync().ConfigureAwait(false);
        _deadline.Dispose(); // the semaphores are left to the garbage collector: a stop may still wait for one, and gets this failure
    }

    /// <summary>Writes a line or a download. The caller holds <see cref="_writing"/>.</summary>
    private async ValueTask PutAsync(string text, ReplyShape shape, int recordLength, TimeSpan timeout, EarlyPrompts prompts = default)
    {
        var count = Begin(text, shape, recordLength, timeout, prompts);
        await WriteAsync(_sent.AsMemory(0, count), text).ConfigureAwait(false);
    }

    /// <returns>The number of bytes to send.</returns>
    private int Begin(string text, ReplyShape shape, int recordLength, TimeSpan timeout, EarlyPrompts prompts = default)
    {
        var isDownload = text.EndsWith('\\');
        _trace?.Write(_name, '>', text);
        Expect(shape, recordLength, isDownload, prompts);
        _underWay = isDownload || shape is ReplyShape.Upload or ReplyShape.Record ? Exchange.Transfer : Exchange.Command;
        if (_sent.Length < text.Length + 1) _sent = new byte[text.Length + 1];
        var count = Encoding.Latin1.GetBytes(text, _sent);
        if (!isDownload) _sent[count++] = (byte)'\r';
        _timeout = timeout + WireTime(count + MaxCommandReply);
        _deadline.Start(_timeout);
        return count;
    }

    private void Expect(ReplyShape shape, int recordLength, bool isDownload, EarlyPrompts prompts = default)
    {
        _framer.Expect(shape, recordLength);
        _echo?.Begin(isDownload, prompts);
    }

    private async ValueTask<bool> WriteInPortionsAsync(int count, string text, CancellationToken cancellation)
    {
        for (var from = 0; from < count;)
        {
            if (from > 0 && cancellation.IsCancellationRequested)
            {
                await WriteAsync("\\"u8.ToArray(), text).ConfigureAwait(false);
                return true;
            }

            var lineEnd = _sent.AsSpan(0, count)[Math.Min(from + DownloadPortion, count)..].IndexOf((byte)'\r');
            var to = lineEnd < 0 ? count : Math.Min(from + DownloadPortion, count) + lineEnd + 1;
            await WriteAsync(_sent.AsMemory(from, to - from), text).ConfigureAwait(false);
            from = to;
        }

        return false;
    }

    private async ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, string text)
    {
        _echo?.Sent(bytes.Span);
        try
        {
            await _link.WriteAsync(bytes, _deadline.Expired).ConfigureAwait(false);
        }
        catch (Exception failure) when (failure is IOException or ObjectDisposedException or OperationCanceledException)
        {
            throw Fail(Describe(failure, text));
        }
    }

    /// <summary>The time that bytes take on a serial line; zero on another link.</summary>
    public TimeSpan WireTime(int bytes) => Line?.Time(bytes) ?? TimeSpan.Zero;

    public async ValueTask<ReplyFrame> ReadFrameAsync(string text) => await TryReadFrameAsync(text).ConfigureAwait(false) ?? throw await HarmedAsync(text, _echo!.UrgentDifference!).ConfigureAwait(false);

    /// <returns>Null where the answer cannot be separated from the echo of an urgent line.</returns>
    public async ValueTask<ReplyFrame?> TryReadFrameAsync(string text)
    {
        while (true)
        {
            if (_echo?.Difference is { } heard) throw await HarmedAsync(text, heard).ConfigureAwait(false);
            if (_echo?.UrgentDifference is not null) return null;
            if (_framer.TryTake(out var frame))
            {
                _trace?.Write(_name, '<', frame.Data + (frame.Accepted ? ":" : "?"));
                return frame;
            }

            await ReadSomeAsync(text).ConfigureAwait(false);
        }
    }

    /// <summary>Waits until all characters of the line have been echoed.</summary>
    public async ValueTask AwaitEchoAsync(string text)
    {
        while (_echo is { IsComplete: false, UrgentDifference: null })
        {
            if (_echo.Difference is { } heard) throw await HarmedAsync(text, heard).ConfigureAwait(false);
            await ReadSomeAsync(text).ConfigureAwait(false);
        }
    }

    private async ValueTask ReadSomeAsync(string text)
    {
        try
        {
            var count = await _link.ReadAsync(_received, _deadline.Expired).ConfigureAwait(false);
            if (count == 0) throw Fail(new ControllerLinkException(Wording.Get("CommandChannel.ClosedConnection", _link.Description)));
            count = _echo?.Strip(_received.AsSpan(0, count)) ?? count;
            _framer.Append(_received.AsSpan(0, count));

            // A whole program memory takes a minute at 19,200 baud: the link counts as alive as long as characters arrive.
            if (Line is not null && _framer.Shape == ReplyShape.Upload) _deadline.Start(_timeout);
        }
        catch (Exception failure) when (failure is IOException or ObjectDisposedException or OperationCanceledException)
        {
            throw Fail(Describe(failure, text));
        }
        catch (ProtocolViolationException failure)
        {
            throw Fail(failure);
        }
    }

    private ControllerException Describe(Exception failure, string text) => failure is OperationCanceledException
        ? text.Length == 0
            ? new ControllerTimeoutException(Wording.Get("CommandChannel.NoReply", _link.Description), failure)
            : text == EchoHandshake.Text
            ? new ControllerTimeoutException(Wording.Get("CommandChannel.NoReplyOnSerialLine", _link.Description), failure)
            : new ControllerTimeoutException(Wording.Get("CommandChannel.NoReplyToCommand", _link.Description, FirstLine(text)), failure)
        : new ControllerLinkException(Wording.Get("CommandChannel.LinkLost", _link.Description, failure.Message), failure);

    private static string FirstLine(string text) => text.IndexOf('\r', StringComparison.Ordinal) is >= 0 and var end ? text[..end] : text;

    /// <summary>The first failure ends all further use.</summary>
    public ControllerException Fail(ControllerException failure) => _failure ??= failure;

    private void OnMessage(string message)
    {
        _trace?.Write(_name, '!', message);
        MessageReceived?.Invoke(message);
    }
}
