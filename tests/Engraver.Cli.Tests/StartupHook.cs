using System.Runtime.InteropServices;

/// <summary>Runs inside the program under test, before its Main (DOTNET_STARTUP_HOOKS; the name and the missing namespace are the runtime's wish): a bug on
/// a thread of the pool, when a test wants it.</summary>
internal static class StartupHook
{
    /// <summary>SIGUSR1 of Linux.</summary>
    public const PosixSignal Trigger = (PosixSignal)10;

    private static PosixSignalRegistration? s_registration;

    public static void Initialize() =>
        s_registration = PosixSignalRegistration.Create(Trigger, signal =>
        {
            signal.Cancel = true; // or the signal itself would end the process
            ThreadPool.QueueUserWorkItem(_ => throw new NotSupportedException("a thread of the pool broke"));
        });
}
