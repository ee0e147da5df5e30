using Engraver.Core.Machines;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>The operator: presses stop at the first report for which the condition is true.</summary>
internal sealed class CancelWhen(Func<JobProgress, bool> condition, Action press) : IProgress<JobProgress>
{
    private bool _pressed;

    public void Report(JobProgress value)
    {
        if (_pressed || !condition(value)) return;
        _pressed = true;
        press();
    }
}
