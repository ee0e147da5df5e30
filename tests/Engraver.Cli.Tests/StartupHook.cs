using System.Runtime.InteropServices;

/// <summary>Runs inside the program under test, before its Main (DOTNET_STARTUP_HOOKS requires this name without a namespace): throws on a pool thread on
/// request.</summary>
internal static class StartupHook
{
    /// <summary>SIGUSR1 of Linux.</summary>
    public const PosixSignal Trigger = (PosixSignal)10;

    private static PosixSignalRegistration? s_registration;

    public static void Initialize() =>
        s_registration = PosixSignalRegistration.Create(Trigger, signal =>
        {
            signal.Cancel = true; // Otherwise the signal itself would end the process.
            ThreadPool.QueueUserWorkItem(_ => throw new NotSupportedException("a thread of the pool broke"));
        });
}
