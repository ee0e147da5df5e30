namespace Engraver.Workbench.Machines;

/// <summary>Runs an urgent action on a new thread, independent of the caller, the UI thread and the thread pool.</summary>
internal static class UrgentThread
{
    /// <summary>Starts the action and returns.</summary>
    public static void Run(Action action) => new Thread(() => action()) { IsBackground = true, Name = "stop", Priority = ThreadPriority.Highest }.Start();
}
