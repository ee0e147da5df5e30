using System.Text;
using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Galil.Protocol;

/// <summary>Commands and replies over one link: one outstanding command, every prompt counted, the reason of a <c>?</c> fetched with TC1 (galil-dmc.md A.3,
/// A.4).</summary>
/// <remarks>A cancellation is honoured before a command is sent; the reply to a sent command is always awaited, otherwise the prompts would no longer
/// match. After an exception of the
/// <see cref="ControllerException"/> family the channel refuses all further use.</remarks>
public sealed partial class CommandChannel : IAsyncDisposable
{
    /// <summary>DL, UL and burning take longer than other commands (galil-dmc.md A.6).</summary>
    public static readonly TimeSpan TransferTimeout = TimeSpan.FromSeconds(10);

    /// <summary>Assumed number of characters of an upload over a serial line, for its time-out, when it is not known.</summary>
    private const int UsualProgram = 10_000;

    /// <summary>Longest reply to a command, bytes, for its time-out on a serial line.</summary>
    private const int LongestCommandReply = 512;

    /// <summary>Bytes of each portion of a download over a serial line, so that it can be cancelled between them.</summary>
    private const int DownloadPortion = 128;

    private const string EchoProbe = "MG \"ECHO\"";

    private readonly IControllerLink _link;
    private readonly string _name;
    private readonly TimeSpan _replyTimeout;
    private readonly IWireTrace? _trace;
    private readonly ReplyDeadline _deadline;
    private readonly ReplyFramer _framer;
    private readonly SemaphoreSlim _turn = new(1, 1);
    private readonly SemaphoreSlim _writing = new(1, 1);
    private readonly byte[] _received = new byte[4096];
    private byte[] _sent = new byte[256];
    private TimeSpan _timeout;
    private ControllerException? _failure;
    private LineEcho? _echo;

    /// <param name="link">Owned: closed with the channel.</param>
    /// <param name="name">The handle's name in the trace.</param>
    public CommandChannel(IControllerLink link, string name, TimeSpan replyTimeout, TimeProvider time, IWireTrace? trace)
    {
        _link = link;
        _name = name;
        _replyTimeout = replyTimeout;
        _trace = trace;
        _deadline = new ReplyDeadline(time);
        _framer = new ReplyFramer { MessageReceived = OnMessage };
    }

    /// <summary>True after a failure: nothing more can be sent.</summary>
    public bool IsBroken => _failure is not null;

    /// <summary>The serial line of this channel; null for none.</summary>
    public SerialLine? Line => _link.Line;

    /// <summary>Called with each line printed by a program in the controller.</summary>
    public Action<string>? MessageReceived { get; set; }

    /// <summary>Sends the first lines on a serial line: ends what an earlier host left open, and switches the echo off (galil-dmc.md F.2).</summary>
    /// <returns>Whether the echo was on.</returns>
    /// <exception cref="ControllerException">No reply.</exception>
    public async ValueTask<bool> GreetAsync(CancellationToken cancellation) =>
        await ExchangeAsync(SerialGreeting.Text, ReplyShape.Greeting, 0, _replyTimeout, cancellation).ConfigureAwait(false) is Accepted { Data: var said } && SerialGreeting.WasEchoed(said);

    /// <summary>From now on every command is compared with its echo (EO 1), because a serial line can damage a byte. With a controller that does not echo
    /// nothing changes.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async ValueTask CompareEchoAsync(CancellationToken cancellation)
    {
        if (await SendAsync("EO 1", cancellation).ConfigureAwait(false) is Rejected) return;
        if (await SendAsync(EchoProbe, cancellation).ConfigureAwait(false) is Accepted { Data: var said } && said.StartsWith(EchoProbe, StringComparison.Ordinal)) _echo = new LineEcho();
    }

    /// <summary>Sends one line and waits for the prompts of all its parts. The first refused part makes the reply a <see cref="Rejected"/>.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    /// <exception cref="EchoException">The echo differs from the sent line; the stop can still be sent.</exception>
    /// <exception cref="ArgumentException">The line breaks the rules of <see cref="CommandLine"/>.</exception>
    public ValueTask<Reply> SendAsync(string line, CancellationToken cancellation)
    {
        var text = CommandLine.Checked(line);
        return _echo is not null && text.Contains(';', StringComparison.Ordinal) ? SendEachAsync(CommandLine.Parts(text), cancellation) : ExchangeAsync(text, ReplyShape.Text, 0, _replyTimeout, cancellation);
    }

    /// <summary>Sends the parts of a line one after the other if echoes are compared, because the reply to one part would otherwise arrive within the echo of
    /// the next. The number of bytes is the same.</summary>
    private async ValueTask<Reply> SendEachAsync(IReadOnlyList<string> parts, CancellationToken cancellation)
    {
        Rejected? refused = null;
        var data = new List<string>();
        foreach (var part in parts)
        {
            var reply = await ExchangeAsync(part, ReplyShape.Text, 0, _replyTimeout, ReferenceEquals(part, parts[0]) ? cancellation : CancellationToken.None).ConfigureAwait(false);
            refused ??= reply as Rejected;
            if (reply is Accepted { Data.Length: > 0 } said) data.Add(said.Data);
        }

        return refused ?? (data.Count == 0 ? Accepted.Silent : (Reply)new Accepted(string.Join('\n', data)));
    }

    /// <summary>UL: the program memory, lines separated by LF, without the end mark; empty when the memory is empty.</summary>
    /// <param name="expected">Number of characters, for the time-out; 0 if it is not known. Some links deliver all characters at once, after their transmission
    /// time.</param>
    public async ValueTask<Reply> UploadAsync(CancellationToken cancellation, int expected = 0) =>
        await ExchangeAsync("UL", ReplyShape.Upload, 0, TransferTimeout + WireTime(Math.Max(expected, UsualProgram)), cancellation).ConfigureAwait(false) is var reply && reply is Accepted text
            ? new Accepted(ProgramText.FromUpload(text.Data))
            : reply;

    /// <summary>DL: replaces the program memory. The controller does not reply until the end mark and then sends two prompts (galil-dmc.md A.6).</summary>
    /// <remarks>The caller ensures that no thread runs: after a refused DL the lines would be executed as commands. On a serial line a cancellation ends the
    /// download early, with the end mark after a complete line (galil-dmc.md F.4); part of the program is then in the memory.</remarks>
    public ValueTask<Reply> DownloadAsync(string program, CancellationToken cancellation) =>
        ExchangeAsync("DL\r" + ProgramText.ForDownload(program) + "\\", ReplyShape.Text, 0, TransferTimeout, cancellation);

    /// <summary>BN: burns the parameters, about a second (galil-dmc.md A.6). It must not be interrupted, so the reply is awaited as long as that of a
    /// transfer.</summary>
    public ValueTask<Reply> BurnAsync(CancellationToken cancellation) => ExchangeAsync("BN", ReplyShape.Text, 0, TransferTimeout, cancellation);

    /// <summary>QR: the data record; each character of the data is one byte.</summary>
    /// <param name="length">Bytes of the record, from QZ.</param>
    public ValueTask<Reply> ReadRecordAsync(int length, CancellationToken cancellation) => ExchangeAsync("QR", ReplyShape.Record, length, _replyTimeout, cancellation);

    public async ValueTask DisposeAsync()
    {
        _failure ??= new ControllerLinkException(Wording.Get("CommandChannel.LinkClosed", _link.Description));
        await _link.DisposeAsync().ConfigureAwait(false);
        _deadline.Dispose(); // the semaphores are not disposed: a stop may still wait for one, and then gets an exception that the link is closed
    }

    private async ValueTask<Reply> ExchangeAsync(string text, ReplyShape shape, int recordLength, TimeSpan timeout, CancellationToken cancellation)
    {
        await _turn.WaitAsync(cancellation).ConfigureAwait(false);
        try
        {
            if (_failure is not null) throw new ControllerLinkException(_failure.Message, _failure);
            var isDownload = text.EndsWith('\\');
            var cutShort = await WriteAsync(text, isDownload, shape, recordLength, timeout, cancellation).ConfigureAwait(false);
            (var data, var refused) = await ReadPartsAsync(text, isDownload).ConfigureAwait(false);
            if (cutShort) throw new OperationCanceledException(cancellation);
            if (refused >= 0) return await FetchReasonAsync(isDownload ? "DL" : CommandLine.Parts(text)[refused]).ConfigureAwait(false);
            return data.Length == 0 ? Accepted.Silent : new Accepted(shape == ReplyShape.Text ? Trimmed(data) : data);
        }
        finally
        {
            _deadline.Stop();
            _underWay = Exchange.None;
            _turn.Release();
        }
    }

    /// <summary>Reads the prompts of all parts.</summary>
    /// <returns>The reply, and the index of the first refused part; -1 for none.</returns>
    private async ValueTask<(string Data, int Refused)> ReadPartsAsync(string text, bool isDownload)
    {
        var parts = isDownload ? 2 : text.Contains(';', StringComparison.Ordinal) ? CommandLine.Parts(text).Count : 1;
        var (data, refused) = ("", -1);
        for (var part = 0; part < parts;)
        {
            if (await TryReadFrameAsync(text).ConfigureAwait(false) is not { } frame)
            {
                await AskAgainAsync(text).ConfigureAwait(false);
                (data, refused, part) = ("", -1, 0);
                continue;
            }

            if (!frame.Accepted && refused < 0) refused = part;

            // The ? for a bad program line comes before the two prompts of the end mark (galil-dmc.md A.6).
            if (frame.Accepted || !isDownload) part++;
            if (frame.Data.Length > 0) data = data.Length == 0 ? frame.Data : data + frame.Data;
        }

        return (data, refused);
    }

    private static string Trimmed(string data) => data.Replace("\r\n", "\n", StringComparison.Ordinal).Trim();

    /// <summary>A <c>?</c> gives no reason; TC1 returns number and text of the reason and clears them.</summary>
    private async ValueTask<Rejected> FetchReasonAsync(string command)
    {
        await WriteAsync("TC1", false, ReplyShape.Text, 0, _replyTimeout, CancellationToken.None).ConfigureAwait(false);
        var frame = await ReadFrameAsync("TC1").ConfigureAwait(false);
        if (!frame.Accepted || !TcCodes.TryParse(frame.Data, out var code, out var text))
            throw Fail(new ProtocolViolationException(Wording.Get("CommandChannel.InvalidReplyToTC1", _link.Description, command, Trimmed(frame.Data))));
        return new Rejected(code, text, command);
    }

    /// <returns>True when a download was ended early.</returns>
    private async ValueTask<bool> WriteAsync(string text, bool isDownload, ReplyShape shape, int recordLength, TimeSpan timeout, CancellationToken cancellation)
    {
        await WritingAsync(text).ConfigureAwait(false);
        try
        {
            if (!isDownload || Line is null) await PutAsync(text, shape, recordLength, timeout).ConfigureAwait(false);
            else return await WriteInPortionsAsync(Begin(text, shape, recordLength, timeout), text, cancellation).ConfigureAwait(false);
            return false;
        }
        finally
        {
            _writing.Release();
        }
    }

    /// <summary>Writes a line or a download. Call under <see cref="_writing"/>.</summary>
    private async ValueTask PutAsync(string text, ReplyShape shape, int recordLength, TimeSpan timeout)
    {
        var count = Begin(text, shape, recordLength, timeout);
        await WriteAsync(_sent.AsMemory(0, count), text).ConfigureAwait(false);
    }

    /// <returns>The number of bytes to send.</returns>
    private int Begin(string text, ReplyShape shape, int recordLength, TimeSpan timeout)
    {
        var isDownload = text.EndsWith('\\');
        _trace?.Write(_name, '>', text);
        Expect(shape, recordLength, isDownload);
        _underWay = isDownload || shape is ReplyShape.Upload or ReplyShape.Record ? Exchange.Transfer : Exchange.Command;
        if (_sent.Length < text.Length + 1) _sent = new byte[text.Length + 1];
        var count = Encoding.Latin1.GetBytes(text, _sent);
        if (!isDownload) _sent[count++] = (byte)'\r';
        _timeout = timeout + WireTime(count + LongestCommandReply);
        _deadline.Start(_timeout);
        return count;
    }

    private void Expect(ReplyShape shape, int recordLength, bool isDownload)
    {
        _framer.Expect(shape, recordLength);
        _echo?.Begin(isDownload);
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

    private TimeSpan WireTime(int bytes) => Line?.Time(bytes) ?? TimeSpan.Zero;

    private async ValueTask<ReplyFrame> ReadFrameAsync(string text) => await TryReadFrameAsync(text).ConfigureAwait(false) ?? throw await HarmedAsync(text, _echo!.UrgentHarm!).ConfigureAwait(false);

    /// <returns>Null if the reply cannot be distinguished from the echo of an urgent line.</returns>
    private async ValueTask<ReplyFrame?> TryReadFrameAsync(string text)
    {
        while (true)
        {
            if (_echo?.Harm is { } heard) throw await HarmedAsync(text, heard).ConfigureAwait(false);
            if (_echo?.UrgentHarm is not null) return null;
            if (_framer.TryTake(out var frame))
            {
                _trace?.Write(_name, '<', frame.Data + (frame.Accepted ? ":" : "?"));
                return frame;
            }

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

            // A full program memory takes a minute at 19,200 baud: the link counts as working as long as characters arrive.
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
            : text == SerialGreeting.Text
            ? new ControllerTimeoutException(Wording.Get("CommandChannel.NoReplyOnSerialLine", _link.Description), failure)
            : new ControllerTimeoutException(Wording.Get("CommandChannel.NoReplyToCommand", _link.Description, FirstLine(text)), failure)
        : new ControllerLinkException(Wording.Get("CommandChannel.LinkLost", _link.Description, failure.Message), failure);

    private static string FirstLine(string text) => text.IndexOf('\r', StringComparison.Ordinal) is >= 0 and var end ? text[..end] : text;

    private ControllerException Fail(ControllerException failure) => _failure ??= failure;

    private void OnMessage(string message)
    {
        _trace?.Write(_name, '!', message);
        MessageReceived?.Invoke(message);
    }
}
