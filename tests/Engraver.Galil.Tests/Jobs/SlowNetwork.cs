using Engraver.Galil.Jobs;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>While something is still to be sent, half a second passes in the controller at every report: less than the watchdog bears, more than the buffer does.</summary>
internal sealed class SlowNetwork(SimulatedController controller) : IProgress<JobProgress>
{
    public void Report(JobProgress value)
    {
        if (value.X > 0 && value.SegmentsSent < value.SegmentCount) controller.Advance(TimeSpan.FromSeconds(0.5));
    }
}
