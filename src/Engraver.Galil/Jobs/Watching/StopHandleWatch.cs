using Engraver.Core.Diagnostics;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Looks now and then whether the handle of the stop still stands: a cut connection says nothing by itself, and the operator must not find out when he presses stop.</summary>
/// <remarks>The feeder never waits for it.</remarks>
internal sealed class StopHandleWatch(ControllerSession session, JobLedger ledger)
{
    private const int PollsBetween = 64;

    private Task<StopHandleLoss?>? _check;
    private int _polls;

    /// <summary>After each poll of the job.</summary>
    public async ValueTask LookAsync()
    {
        if (_check is { IsCompleted: true }) await EndAsync().ConfigureAwait(false);
        if (_check is null && ++_polls % PollsBetween == 0) _check = session.CheckStopHandleAsync(CancellationToken.None);
    }

    /// <summary>The check under way, if there is one, is waited for and told.</summary>
    public async ValueTask EndAsync()
    {
        if (_check is not { } check) return;
        _check = null;
        if (await check.ConfigureAwait(false) is not { } loss) return;
        ledger.Warnings.Add(loss.NotReopened is { } failure
            ? MotionRules.StopHandleLost.At(default, loss.Reason, failure)
            : MotionRules.StopHandleReopened.At(default, loss.Reason));
    }
}
