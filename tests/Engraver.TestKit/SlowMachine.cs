namespace Engraver.TestKit;

/// <summary>A simulated machine that is slow enough to be met in the middle of a job.</summary>
public static class SlowMachine
{
    /// <summary>Nearly as fast as a real one, by its own clock, which stands still while a busy computer holds the job up. At exactly speed 1 the job goes
    /// by the wall, and its watchdog
    /// stops the machine after a second without the job, as it should; a test of something else must not depend on that.</summary>
    public const string Address = "sim:?speed=0.9";
}
