using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>The commands and queries of a job, with the heartbeats of the watchdog between them. Nothing is sent after the operator's stop. A rejected
/// command ends the job.</summary>
internal sealed class JobCommands(ControllerSession session, StopOrder order, JobLedger ledger, ProgressWatch progress)
{
    private Heartbeat _heartbeat = new(session.Time);
    private string _beat = ResidentServer.HeartbeatCommand;
    private HeartbeatKeeper? _keeper;

    /// <summary>Time without a heartbeat after which the watchdog trips.</summary>
    public double WatchdogSeconds => _heartbeat.WatchdogSeconds;

    /// <param name="where">Text added to the report of a rejection.</param>
    public async ValueTask SendAsync(string command, string where = "")
    {
        if (await ReplyAsync(command).ConfigureAwait(false) is Rejected rejected) throw Refuse(rejected, where).ToException();
    }

    public async ValueTask SendAllAsync(IEnumerable<string> commands)
    {
        foreach (var command in commands) await SendAsync(command).ConfigureAwait(false);
    }

    /// <summary>Sends one command, and the heartbeat when it is due. A rejection is returned and does not end the job.</summary>
    public async ValueTask<Reply> ReplyAsync(string command)
    {
        _keeper?.ThrowIfFailed();
        if (IsBeatDueBefore(command.Length) && await session.Commands.SendAsync(_beat, order.ToSend()).ConfigureAwait(false) is Rejected unbeaten) return unbeaten;
        var reply = await session.Commands.SendAsync(command, order.ToSend()).ConfigureAwait(false);
        if (reply is Accepted && command != _beat) progress.Acted();
        if (!_heartbeat.IsDue()) return reply;
        var beat = await session.Commands.SendAsync(_beat, order.ToSend()).ConfigureAwait(false);
        return beat is Rejected && reply is Accepted ? beat : reply;
    }

    /// <summary>Sends the next of these segments, on a serial line as many as one line takes. A rejection is returned and does not end the job.</summary>
    /// <param name="segments">Those that may be sent, in order; at least one.</param>
    public async ValueTask<SentSegments> ReplyAsync(IEnumerable<string> segments)
    {
        _keeper?.ThrowIfFailed();
        var first = segments.First();
        if (session.Line is not { } line) return SentSegments.One(await ReplyAsync(first).ConfigureAwait(false), first);
        var beats = StreamLines.Fit(line, _beat, first) && _heartbeat.IsDueWithSegments() ? 1 : 0;
        var statements = StreamLines.Next(line, beats > 0 ? _beat : null, segments);
        if (statements.Count == 1) return SentSegments.One(await ReplyAsync(first).ConfigureAwait(false), first);
        var text = string.Join(';', statements);
        var bytes = text.Length + 1 + statements.Count;
        if (IsBeatDueBefore(bytes) && await session.Commands.SendAsync(_beat, order.ToSend()).ConfigureAwait(false) is Rejected unbeaten) return new SentSegments(unbeaten, 0, statements.Count - beats, 0);
        var reply = await session.Commands.SendWholeAsync(text, order.ToSend()).ConfigureAwait(false);
        if (reply is not Rejected refused) progress.Acted();
        else return new SentSegments(reply, Math.Max(0, refused.Part - beats), statements.Count - beats, bytes);
        return new SentSegments(reply, statements.Count - beats, statements.Count - beats, bytes);
    }

    /// <summary>From now on heartbeats are also sent where this computer delays the job. Not on a clock that is not the computer's: on it the job is never
    /// late.</summary>
    public void KeepBeating()
    {
        if (session.Time == TimeProvider.System) _keeper ??= new HeartbeatKeeper(session.Time, () => _heartbeat.IsDueBeside(), async () => await session.Commands.SendAsync(_beat, order.ToSend()).ConfigureAwait(false));
    }

    /// <summary>Ends <see cref="KeepBeating"/>.</summary>
    public async ValueTask EndBeatingAsync()
    {
        if (_keeper is { } keeper) await keeper.DisposeAsync().ConfigureAwait(false);
        _keeper = null;
    }

    /// <summary>Sends the heartbeat if it is due.</summary>
    public ValueTask BeatAsync() => _heartbeat.IsDue() ? SendAsync(_beat) : ValueTask.CompletedTask;

    /// <summary>From now on the watchdog trips 0.25 s after the last heartbeat, and heartbeats are sent more often: for motion that lasts as long as a key is
    /// held.</summary>
    public ValueTask WatchCloselyAsync()
    {
        _heartbeat = Heartbeat.Close(session.Time);
        _beat = ResidentServer.CloseHeartbeatCommand;
        return SendAsync(_beat);
    }

    /// <summary>Ends <see cref="WatchCloselyAsync"/>: the watchdog has its usual time again.</summary>
    public ValueTask WatchAsUsualAsync()
    {
        _heartbeat = new Heartbeat(session.Time);
        _beat = ResidentServer.HeartbeatCommand;
        return SendAsync(_beat);
    }

    /// <summary>Queries one number.</summary>
    public async ValueTask<double> AskAsync(string operand) => (await AskAllAsync(operand).ConfigureAwait(false))[0];

    /// <summary>Queries several numbers at once.</summary>
    public async ValueTask<IReadOnlyList<double>> AskAllAsync(string operands)
    {
        var reading = await session.Commands.ReadAsync(operands, order.ToSend()).ConfigureAwait(false);
        return reading.Refusal is { } refused ? throw Refuse(refused, "").ToException() : reading.Values;
    }

    /// <summary>Queries one number that the controller may not know: null then.</summary>
    public async ValueTask<double?> TryAskAsync(string operand)
    {
        var reading = await session.Commands.ReadAsync(operand, order.ToSend()).ConfigureAwait(false);
        if (reading.Refusal is not null) ledger.Rejected++;
        return reading.ValuesOrEmpty;
    }

    /// <summary>Queries one part of the machine's state, and sends the heartbeat before it if the exchange would delay it for too long.</summary>
    public async ValueTask<IReadOnlyList<double>> AskAllAsync(StateQuestion question)
    {
        if (IsBeatDueBefore(2 * question.Text.Length)) await SendAsync(_beat).ConfigureAwait(false);
        return await AskAllAsync(question.Text).ConfigureAwait(false);
    }

    /// <summary>Queries one number over the stop handle, also after the operator's stop; null when the controller does not know it.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async ValueTask<double?> AskAtRestAsync(string operand) => (await session.StopHandle.ReadAsync(operand, CancellationToken.None).ConfigureAwait(false)).ValuesOrEmpty;

    /// <summary>Counts a rejected command and makes it the end of the job.</summary>
    public JobEnd Refuse(Rejected rejected, string where)
    {
        ledger.Rejected++;
        return JobEnd.Refused(rejected, where);
    }

    private bool IsBeatDueBefore(int bytes) => session.Line is { } line && _heartbeat.IsDueBefore(line.Time(bytes));
}
