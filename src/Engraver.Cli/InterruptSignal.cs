using System.Globalization;
using System.Runtime.InteropServices;

namespace Engraver.Cli;

/// <summary>Ensures that the program receives SIGINT. A shell without job control starts background commands with SIGINT ignored, and the runtime keeps that
/// setting. A program that moves a machine must not ignore the signal, because it is sent to stop the machine.</summary>
internal static class InterruptSignal
{
    private const int Interrupt = 2;
    private const nint Default = 0;

    /// <summary>Call before registering a handler. Does nothing if the signal is not ignored, or on other systems than Linux.</summary>
    public static void RestoreDefault()
    {
        if (OperatingSystem.IsLinux() && IsIgnored()) NativeMethods.Signal(Interrupt, Default);
    }

    /// <summary>The mask of ignored signals in /proc, bit 0 is signal 1.</summary>
    private static bool IsIgnored()
    {
        const string Label = "SigIgn:";
        var line = File.ReadLines("/proc/self/status").FirstOrDefault(text => text.StartsWith(Label, StringComparison.Ordinal));
        return line is not null
            && ulong.TryParse(line.AsSpan(Label.Length).Trim(), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var mask)
            && (mask & (1UL << (Interrupt - 1))) != 0;
    }

    private static class NativeMethods
    {
        [DllImport("libc", EntryPoint = "signal")]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        public static extern nint Signal(int number, nint handler);
    }
}
