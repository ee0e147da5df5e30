using Engraver.SoftwarePlatform.Tests.X11;

namespace Engraver.App.Tests.RealWindow;

public sealed class BusyThreadsTests
{
    private const int MaxLooks = 1000;
    private static readonly TimeSpan s_look = TimeSpan.FromMilliseconds(5);

    [XServerFact]
    public void A_program_that_computes_is_met_at_work_twice_in_a_row()
    {
        using var program = new LineProcess("sh", null, "-c", "echo ready; while :; do :; done");
        program.WaitFor("ready");

        Assert.True(IsMet(program, times: 5, atWork: true));
    }

    [XServerFact]
    public void A_program_that_waits_is_not()
    {
        using var program = new LineProcess("sh", null, "-c", "echo ready; exec cat");
        program.WaitFor("ready");

        Assert.True(IsMet(program, times: 20, atWork: false));
    }

    /// <summary>Whether a number of consecutive samples have the result, within the timeout of the test.</summary>
    private static bool IsMet(LineProcess program, int times, bool atWork)
    {
        var (work, same) = (new BusyThreads(program.Id), 0);
        using var looks = new PollingTimer(s_look);
        for (var look = 0; look < MaxLooks && same < times; look++)
        {
            looks.WaitForNext();
            same = work.StillBusy() == atWork ? same + 1 : 0;
        }

        return same == times;
    }
}
