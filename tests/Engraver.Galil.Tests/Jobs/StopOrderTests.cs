using Engraver.Galil.Jobs;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>A stop sends the braking first, before anything else that waits for it.</summary>
public class StopOrderTests
{
    [Fact]
    public void The_machine_is_braked_before_any_wait_of_the_job_ends()
    {
        var said = new List<string>();
        using var stop = new CancellationTokenSource();
        using var order = new StopOrder(stop.Token);
        order.BrakeBy(() => said.Add("brake"));
        using var late = order.Work.Register(() => said.Add("the job ends"));

        stop.Cancel();

        Assert.Equal(["brake", "the job ends"], said);
    }

    [Fact]
    public void Behind_the_press_nothing_is_sent_while_the_braking_is_under_way()
    {
        using var stop = new CancellationTokenSource();
        using var order = new StopOrder(stop.Token);
        var (sent, ended) = (false, true);
        order.BrakeBy(() =>
        {
            ended = order.Work.IsCancellationRequested;
            try
            {
                order.ToSend();
                sent = true;
            }
            catch (OperationCanceledException)
            {
            }
        });

        stop.Cancel();

        Assert.Equal((false, false, true), (sent, ended, order.Work.IsCancellationRequested));
    }

    [Fact]
    public void Once_the_machine_is_no_longer_the_jobs_a_stop_only_ends_its_waits()
    {
        var braked = false;
        using var stop = new CancellationTokenSource();
        using var order = new StopOrder(stop.Token);
        order.BrakeBy(() => braked = true);
        order.BrakeBy(null);

        stop.Cancel();

        Assert.Equal((false, true, true), (braked, order.IsPressed, order.Work.IsCancellationRequested));
    }
}
