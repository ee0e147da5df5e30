using Engraver.App.MachineStrip;
using Engraver.Core.Geometry;
using Engraver.Workbench.Machines;

namespace Engraver.App.Tests.MachineStrip;

public sealed class ReportedSpeedTests
{
    [Fact]
    public void Two_words_make_a_speed()
    {
        var speed = new ReportedSpeed();
        speed.Update(Progress(1.0, 10.0));
        Assert.Null(speed.Current);
        speed.Update(Progress(1.5, 16.0));

        Assert.Equal(12.0, speed.Current!.Value, 9);
    }

    [Fact]
    public void Words_that_are_too_close_together_are_passed_over()
    {
        var speed = new ReportedSpeed();
        speed.Update(Progress(1.0, 0.0));
        speed.Update(Progress(1.2, 2.0));
        speed.Update(Progress(1.21, 9.0));
        Assert.Equal(10.0, speed.Current!.Value, 9);
        speed.Update(Progress(1.4, 6.0));

        Assert.Equal(20.0, speed.Current!.Value, 9);
    }

    [Fact]
    public void The_end_of_a_job_and_the_beginning_of_another_say_nothing_of_the_speed()
    {
        var speed = new ReportedSpeed();
        speed.Update(Progress(1.0, 0.0));
        speed.Update(Progress(2.0, 5.0));
        speed.Update(Progress(0.1, 0.0));
        Assert.Null(speed.Current);
        speed.Update(Progress(1.1, 3.0));
        Assert.Equal(3.0, speed.Current!.Value, 9);
        speed.Update(null);
        Assert.Null(speed.Current);
    }

    private static EngravedProgress Progress(double seconds, double x) => new(0, 1, 10, new Point2D(x, 0.0), true, seconds);
}
