namespace Engraver.TestKit;

/// <summary>A simulated machine that is slow enough for a test to act in the middle of a job.</summary>
public static class SlowSimulator
{
    /// <summary>Almost the speed of a real machine, by its own clock, which does not advance while a busy computer delays the job. At exactly speed 1 the job
    /// uses the wall clock, and its watchdog stops the machine after a second without the job; tests of other features must not depend on that.</summary>
    public const string Address = "sim:?speed=0.9";
}
