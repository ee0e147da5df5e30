using Engraver.Core.Machines;
using Engraver.Galil.Jobs;

namespace Engraver.Galil.Tests.Jobs.Loop;

/// <summary>A step ends the job by an exception that only <see cref="JobEnd.OfAsync"/> catches.</summary>
public class JobEndTests
{
    [Fact]
    public async Task A_step_that_is_completed_has_no_end() => Assert.Null(await JobEnd.OfAsync(() => ValueTask.CompletedTask));

    [Fact]
    public async Task A_step_that_ends_the_job_gives_its_end_unchanged_through_every_method_and_scope()
    {
        var end = JobEnd.LinkLost("The cable was cut.", LinkLoss.Watchdog) with { Doubt = "steps" };
        var left = 0;

        var found = await JobEnd.OfAsync(() => ThroughAsync(5));

        Assert.Same(end, found);
        Assert.Equal((true, 6), (found!.IsEarly, left));

        async ValueTask ThroughAsync(int more)
        {
            try
            {
                await Task.Yield();
                if (more > 0) await ThroughAsync(more - 1);
                else throw end.ToException();
            }
            finally
            {
                left++;
            }
        }
    }

    [Fact]
    public async Task Other_exceptions_pass() =>
        await Assert.ThrowsAsync<ControllerLinkException>(async () => await JobEnd.OfAsync(() => throw new ControllerLinkException("The cable was cut.")));

    [Fact]
    public void A_complete_job_has_not_ended_early() => Assert.False(JobEnd.Complete("Done.").IsEarly);
}
