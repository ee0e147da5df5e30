using Engraver.Core.Diagnostics;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Tests from time to time whether the stop handle still works: a cut connection is not reported until something is sent, and the operator must
/// not be the first to find out when pressing stop.</summary>
/// <remarks>The sending of segments never waits for it.</remarks>
internal sealed class StopHandleWatch(ControllerSession session, JobLedger ledger)
{
    private const int PollsBetween = 64;

    private Task<StopHandleLoss?>? _check;
    private int _polls;

    /// <summary>Call after each poll of the job.</summary>
    public async ValueTask LookAsync()
    {
        if (_check is { IsCompleted: true }) await EndAsync().ConfigureAwait(false);
        if (_check is null && ++_polls % PollsBetween == 0) _check = session.CheckStopHandleAsync(CancellationToken.None);
    }

    /// <summary>Waits for the test that is in progress, if any, and reports its result.</summary>
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
