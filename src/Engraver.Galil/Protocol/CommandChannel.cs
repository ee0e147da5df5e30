using Engraver.Core.Machines;
using Engraver.Core.Motion;

namespace Engraver.Galil.Protocol;

/// <summary>Commands and replies over one link: one outstanding command, every prompt counted, the reason of a <c>?</c> fetched with TC1 (galil-dmc.md A.3,
/// A.4).</summary>
/// <remarks>A cancellation is honoured before a command is sent; the reply to a sent command is always awaited, otherwise the prompts would no longer
/// match. After an exception of the <see cref="ControllerException"/> family the channel refuses all further use.</remarks>
public sealed class CommandChannel : IAsyncDisposable
{
    /// <summary>DL, UL and burning take longer than other commands (galil-dmc.md A.6).</summary>
    public static readonly TimeSpan TransferTimeout = TimeSpan.FromSeconds(10);

    /// <summary>Assumed number of characters of an upload over a serial line, for its time-out, when it is not known.</summary>
    private const int UsualProgram = 10_000;

    private const string EchoProbe = "MG \"ECHO\"";

    private readonly CommandWire _wire;
    private readonly TimeSpan _replyTimeout;
    private readonly SemaphoreSlim _turn = new(1, 1);

    /// <param name="link">Owned: closed with the channel.</param>
    /// <param name="name">The handle's name in the trace.</param>
    public CommandChannel(IControllerLink link, string name, TimeSpan replyTimeout, TimeProvider time, IWireTrace? trace)
    {
        _replyTimeout = replyTimeout;
        _wire = new CommandWire(link, name, replyTimeout, time, trace);
    }

    /// <summary>True after a failure: nothing more can be sent.</summary>
    public bool IsBroken => _wire.Failure is not null;

    /// <summary>The serial line of this channel; null for none.</summary>
    public SerialLine? Line => _wire.Line;

    /// <summary>Total time in which a command, download or upload was under way on this channel.</summary>
    public TimeSpan Busy => _wire.Busy;

    /// <summary>Called with each line printed by a program in the controller.</summary>
    public Action<string>? MessageReceived
    {
        get => _wire.MessageReceived;
        set => _wire.MessageReceived = value;
    }

    /// <summary>Sends the first lines on a serial line: ends what an earlier host left open, and switches the echo off (galil-dmc.md F.2).</summary>
    /// <returns>Whether the echo was on.</returns>
    /// <exception cref="ControllerException">No reply.</exception>
    public async ValueTask<bool> GreetAsync(CancellationToken cancellation) =>
        await ExchangeAsync(EchoHandshake.Text, ReplyShape.Greeting, 0, _replyTimeout, cancellation).ConfigureAwait(false) is Accepted { Data: var said } && EchoHandshake.WasEchoed(said);

    /// <summary>From now on every command is compared with its echo (EO 1), because a serial line can damage a byte. With a controller that does not echo
    /// nothing changes.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async ValueTask CompareEchoAsync(CancellationToken cancellation)
    {
        if (await SendAsync("EO 1", cancellation).ConfigureAwait(false) is Rejected) return;
        if (await SendAsync(EchoProbe, cancellation).ConfigureAwait(false) is Accepted { Data: var said } && said.StartsWith(EchoProbe, StringComparison.Ordinal)) _wire.CompareEcho(hasLineEnd: said.AsSpan(EchoProbe.Length) is ['\r' or '\n', ..]);
    }

    /// <summary>Sends one line and waits for the prompts of all its parts. The first refused part makes the reply a <see cref="Rejected"/>.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    /// <exception cref="EchoException">The echo differs from the sent line; the stop can still be sent.</exception>
    /// <exception cref="ArgumentException">The line breaks the rules of <see cref="CommandLine"/>.</exception>
    public ValueTask<Reply> SendAsync(string line, CancellationToken cancellation)
    {
        var text = CommandLine.Checked(line);
        return _wire.ComparesEcho && text.Contains(';', StringComparison.Ordinal) ? SendEachAsync(CommandLine.Parts(text), cancellation) : ExchangeAsync(text, ReplyShape.Text, 0, _replyTimeout, cancellation);
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

    /// <summary>Sends a line whose statements are answered by prompts alone, whole also where echoes are compared: one exchange for all of them.</summary>
    /// <param name="line">Without colons, question marks and quotes.</param>
    /// <returns>The first refused statement makes the reply a <see cref="Rejected"/>. Whether the controller executed those after it is then not known: whether
    /// it answers them is not confirmed (galil-dmc.md A.3), and either is accepted.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    /// <exception cref="EchoException">The echo differs from the sent line; the stop can still be sent.</exception>
    /// <exception cref="ArgumentException">The line breaks the rules of <see cref="CommandLine"/>, or its statements are not answered by prompts
    /// alone.</exception>
    public ValueTask<Reply> SendWholeAsync(string line, CancellationToken cancellation)
    {
        var text = CommandLine.Checked(line);
        if (text.AsSpan().ContainsAny(':', '?', '"')) throw new ArgumentException($"'{line}' is not answered by prompts alone.", nameof(line));
        return InTurnAsync(() => ExchangeWholeAsync(text, CommandLine.Parts(text), cancellation), cancellation);
    }

    /// <summary>UL: the program memory, lines separated by LF, without the end mark; empty when the memory is empty.</summary>
    /// <param name="expected">Number of characters, for the time-out; 0 if it is not known. Some links deliver all characters at once, after their transmission
    /// time.</param>
    public async ValueTask<Reply> UploadAsync(CancellationToken cancellation, int expected = 0) =>
        await ExchangeAsync("UL", ReplyShape.Upload, 0, TransferTimeout + _wire.WireTime(Math.Max(expected, UsualProgram)), cancellation).ConfigureAwait(false) is var reply && reply is Accepted text
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

    /// <summary>Puts a line of commands on the wire at once, also where another command waits for its answer, which may be late or lost; its own prompts
    /// are taken before the next command goes out. Does nothing on a network handle that is free, where <see cref="SendAsync"/> is as quick, and on a
    /// serial line during a transfer. On a free serial line it goes out too: a question that took the turn in between would delay it as long as its
    /// answer takes.</summary>
    /// <param name="line">Its parts are answered by prompts alone.</param>
    /// <remarks>The controller's answer is not returned: send the line again in its turn. Where echoes are compared the whole line goes out at once, and
    /// not part by part as with <see cref="SendAsync"/>.</remarks>
    public ValueTask SendUrgentAsync(string line) => _wire.UrgeAsync(CommandLine.Checked(line), isFree: _turn.CurrentCount > 0);

    public ValueTask DisposeAsync() => _wire.DisposeAsync(); // the turn is left to the garbage collector: a stop may still wait for it, and gets the wire's failure

    private ValueTask<Reply> ExchangeAsync(string text, ReplyShape shape, int recordLength, TimeSpan timeout, CancellationToken cancellation) => InTurnAsync(
        async () =>
        {
            var isDownload = text.EndsWith('\\');
            var cutShort = await _wire.WriteAsync(text, isDownload, shape, recordLength, timeout, cancellation).ConfigureAwait(false);
            (var data, var refused) = await ReadPartsAsync(text, isDownload).ConfigureAwait(false);
            if (cutShort) throw new OperationCanceledException(cancellation);
            if (refused >= 0) return await FetchReasonAsync(isDownload ? "DL" : CommandLine.Parts(text)[refused], refused).ConfigureAwait(false);
            return data.Length == 0 ? Accepted.Silent : new Accepted(shape == ReplyShape.Text ? Trimmed(data) : data);
        },
        cancellation);

    private async ValueTask<Reply> ExchangeWholeAsync(string text, IReadOnlyList<string> parts, CancellationToken cancellation)
    {
        await _wire.WriteAsync(text, false, ReplyShape.Text, 0, _replyTimeout, cancellation, new EarlyPrompts(parts.Count, 0)).ConfigureAwait(false);
        for (var part = 0; part < parts.Count; part++)
        {
            if (await _wire.ReadFrameAsync(text).ConfigureAwait(false) is { Accepted: true }) continue;
            await _wire.AwaitEchoAsync(text).ConfigureAwait(false);
            return await FetchReasonAsync(parts[part], part, parts.Count - part - 1).ConfigureAwait(false);
        }

        return Accepted.Silent;
    }

    private async ValueTask<Reply> InTurnAsync(Func<ValueTask<Reply>> exchange, CancellationToken cancellation)
    {
        await _turn.WaitAsync(cancellation).ConfigureAwait(false);
        try
        {
            if (_wire.Failure is { } failure) throw new ControllerLinkException(failure.Message, failure);
            return await exchange().ConfigureAwait(false);
        }
        finally
        {
            _wire.EndExchange();
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
            if (await _wire.TryReadFrameAsync(text).ConfigureAwait(false) is not { } frame)
            {
                await _wire.AskAgainAsync(text).ConfigureAwait(false);
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
    /// <param name="part">Index of the refused command in its line.</param>
    /// <param name="late">The most prompts that may come before the reply to TC1: those of the statements after the refused one.</param>
    private async ValueTask<Rejected> FetchReasonAsync(string command, int part, int late = 0)
    {
        await _wire.WriteAsync("TC1", false, ReplyShape.Text, 0, _replyTimeout, CancellationToken.None, new EarlyPrompts(0, late)).ConfigureAwait(false);
        var frame = await _wire.ReadFrameAsync("TC1").ConfigureAwait(false);
        for (; late > 0 && frame.Data.Length == 0; late--) frame = await _wire.ReadFrameAsync("TC1").ConfigureAwait(false);
        if (!frame.Accepted || !TcCodes.TryParse(frame.Data, out var code, out var text))
            throw _wire.Fail(new ProtocolViolationException(Wording.Get("CommandChannel.InvalidReplyToTC1", _wire.Description, command, Trimmed(frame.Data))));
        return new Rejected(code, text, command) { Part = part };
    }
}
