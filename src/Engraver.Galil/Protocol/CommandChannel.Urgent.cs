using System.Text;
using Engraver.Core.Machines;

namespace Engraver.Galil.Protocol;

/// <content>Lines that are sent immediately, and how replies and echoes that they overtake are handled.</content>
public sealed partial class CommandChannel
{
    /// <summary>The exchange that is not completely answered yet; set under <see cref="_writing"/>.</summary>
    private volatile Exchange _underWay = Exchange.None;

    /// <summary>Number of prompts of urgent lines that are not taken yet; changed under <see cref="_writing"/>.</summary>
    private int _owed;

    /// <summary>True when the echo of an urgent line could not be distinguished from a reply: from then on the stop waits for its turn.</summary>
    private volatile bool _echoesMix;

    private enum Exchange
    {
        None,
        Command,

        /// <summary>A download, an upload or a record: on a serial line its bytes cannot be distinguished from those of another line.</summary>
        Transfer,
    }

    /// <summary>Sends a line of commands immediately, even if another command waits for a reply that may be late or lost; its own prompts are taken before the
    /// next command is sent. Does nothing on a free network handle, where <see cref="SendAsync"/> is as fast, and on a serial line during a transfer. On a free
    /// serial line it is sent as well, because a query sent first would delay it by the time of its reply.</summary>
    /// <param name="line">Its parts are answered by prompts only.</param>
    /// <remarks>The reply of the controller is not reported: send the line again in its turn. Where echoes are compared, the whole line is sent at once and not
    /// part by part as by <see cref="SendAsync"/>.</remarks>
    public async ValueTask UrgeAsync(string line)
    {
        var text = CommandLine.Checked(line);
        if (_echoesMix || (Line is null && _turn.CurrentCount > 0)) return;
        await _writing.WaitAsync().ConfigureAwait(false);
        try
        {
            if (_failure is not null || (Line is not null && _underWay == Exchange.Transfer)) return;
            _trace?.Write(_name, '>', text);
            var bytes = Encoding.Latin1.GetBytes(text + "\r");
            if (_underWay == Exchange.None && _owed == 0) Expect(ReplyShape.Text, 0, isDownload: false);
            _owed += CommandLine.Parts(text).Count;
            _echo?.Overtaken(bytes);
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

    /// <summary>Takes the prompts of urgent lines, so that later prompts belong to the next line, and prevents other writes before it.</summary>
    private async ValueTask WritingAsync(string text)
    {
        await _writing.WaitAsync().ConfigureAwait(false);
        if (_owed == 0) return;
        try
        {
            _deadline.Start(_replyTimeout + WireTime(LongestCommandReply));
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

    /// <summary>The echo of an urgent line cannot be distinguished from a reply: ends a partly sent line and restarts the comparison. Call under
    /// <see cref="_writing"/>.</summary>
    private async ValueTask GreetAgainAsync()
    {
        _echoesMix = true;
        (var compares, _echo, _owed) = (_echo, null, 1); // the reply to the greeting comes after the prompts of all urgent lines
        foreach (var (text, shape) in new[] { (SerialGreeting.Text, ReplyShape.Greeting), ("EO 1", ReplyShape.Text) })
        {
            await PutAsync(text, shape, 0, _replyTimeout).ConfigureAwait(false);
            await TryReadFrameAsync(text).ConfigureAwait(false);
        }

        _echo = compares;
        _echo?.Begin(false);
    }

    /// <summary>The reply to this command is mixed with the echo of an urgent line: a query is sent again.</summary>
    /// <exception cref="EchoException">The text is a command that is answered by a prompt only: the urgent line was damaged, and whether the command was
    /// executed is not known.</exception>
    private async ValueTask AskAgainAsync(string text)
    {
        var heard = _echo!.UrgentHarm!;
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

    /// <summary>After a wrong echo it is not known what the controller executed, but a stop must still reach it: the greeting is sent again, which ends a
    /// partly sent command, and the channel continues without echoes.</summary>
    private async ValueTask<EchoException> HarmedAsync(string text, string heard)
    {
        await _writing.WaitAsync().ConfigureAwait(false);
        try
        {
            (_echo, _owed) = (null, 0); // the reply to the greeting comes after the prompts of all urgent lines
            await PutAsync(SerialGreeting.Text, ReplyShape.Greeting, 0, _replyTimeout).ConfigureAwait(false);
        }
        finally
        {
            _writing.Release();
        }

        await TryReadFrameAsync(SerialGreeting.Text).ConfigureAwait(false);
        return Harmed(text, heard);
    }

    private EchoException Harmed(string text, string heard) => new(Wording.Get("CommandChannel.EchoDiffers", _link.Description, heard.TrimEnd('\r'), FirstLine(text)));
}
