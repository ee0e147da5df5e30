using System.Text;
using Engraver.Core.Machines;

namespace Engraver.Galil.Protocol;

/// <content>Lines that cannot wait for their turn, and what becomes of the answers and echoes that they overtake.</content>
public sealed partial class CommandChannel
{
    /// <summary>What is on the wire and not wholly answered; set by whoever holds <see cref="_writing"/>.</summary>
    private volatile Exchange _underWay = Exchange.None;

    /// <summary>Prompts of urgent lines that nobody has taken yet; whoever holds <see cref="_writing"/> changes it.</summary>
    private int _owed;

    /// <summary>The echo of an urgent line could not be told from an answer: from then on the stop waits for its turn.</summary>
    private volatile bool _echoesMix;

    private enum Exchange
    {
        None,
        Command,

        /// <summary>A download, an upload or a record: on a serial line its bytes are not told from those of another line.</summary>
        Transfer,
    }

    /// <summary>Puts a line of commands on the wire at once, also where another command waits for its answer, which may be late or lost; its own prompts
    /// are taken before the next command goes out. Does nothing on a network handle that is free, where <see cref="SendAsync"/> is as quick, and on a
    /// serial line during a transfer. On a free serial line it goes out too: a question that took the turn in between would hold it up as long as its
    /// answer takes.</summary>
    /// <param name="line">Its parts are answered by prompts alone.</param>
    /// <remarks>What the controller answers is not told: send the line again in its turn. Where echoes are compared the whole line goes out at once, and
    /// not part by part as <see cref="SendAsync"/> does it.</remarks>
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

    /// <summary>Takes the prompts of urgent lines, so that those which come then belong to the next line, and lets nobody else write before it.</summary>
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

    /// <summary>The echo of an urgent line cannot be told from an answer: ends what is half said and begins to compare anew. The caller holds
    /// <see cref="_writing"/>.</summary>
    private async ValueTask GreetAgainAsync()
    {
        _echoesMix = true;
        (var compares, _echo, _owed) = (_echo, null, 1); // the answer to the greeting is behind the prompts of every urgent line
        foreach (var (text, shape) in new[] { (SerialGreeting.Text, ReplyShape.Greeting), ("EO 1", ReplyShape.Text) })
        {
            await PutAsync(text, shape, 0, _replyTimeout).ConfigureAwait(false);
            await TryReadFrameAsync(text).ConfigureAwait(false);
        }

        _echo = compares;
        _echo?.Begin(false);
    }

    /// <summary>The answer to this command is mixed with the echo of an urgent line: a question is put again.</summary>
    /// <exception cref="EchoException">The text is a command, which is answered by a prompt alone: the urgent line was harmed, and whether the command was
    /// done is not known.</exception>
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

    /// <summary>After a wrong echo it is not known what the controller executed, but the stop must still reach it: the line is greeted again, which ends
    /// any half command, and continues without echoes.</summary>
    private async ValueTask<EchoException> HarmedAsync(string text, string heard)
    {
        await _writing.WaitAsync().ConfigureAwait(false);
        try
        {
            (_echo, _owed) = (null, 0); // the answer to the greeting is behind the prompts of every urgent line
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
