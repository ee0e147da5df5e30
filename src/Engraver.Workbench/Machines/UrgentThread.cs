namespace Engraver.Workbench.Machines;

/// <summary>A thread for one act that must not wait for the caller, the window's thread or a busy pool.</summary>
internal static class UrgentThread
{
    /// <summary>Begins the act at once and returns.</summary>
    public static void Run(Action act) => new Thread(() => act()) { IsBackground = true, Name = "stop", Priority = ThreadPriority.Highest }.Start();
}
