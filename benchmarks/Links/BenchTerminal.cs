using System.Globalization;
using System.Runtime.InteropServices;
using Microsoft.Win32.SafeHandles;

[assembly: DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]

namespace Engraver.Benchmarks.Links;

/// <summary>The other side of a serial line: the master of a Linux pseudo-terminal, of which a link opens the slave.</summary>
internal sealed class BenchTerminal : IDisposable
{
    private const nuint TerminalNumber = 0x80045430; // TIOCGPTN
    private const nuint SetLock = 0x40045431; // TIOCSPTLCK

    private readonly FileStream _master;

    /// <exception cref="PlatformNotSupportedException">The system is not Linux.</exception>
    /// <exception cref="IOException">The system has no free terminal.</exception>
    public BenchTerminal()
    {
        if (!OperatingSystem.IsLinux()) throw new PlatformNotSupportedException("a pseudo-terminal is opened on Linux only.");
        _master = new FileStream("/dev/ptmx", FileMode.Open, FileAccess.ReadWrite, FileShare.ReadWrite, bufferSize: 0);
        var (number, unlocked) = (0, 0);
        if (Control(_master.SafeFileHandle, SetLock, ref unlocked) != 0 || Control(_master.SafeFileHandle, TerminalNumber, ref number) != 0) throw new IOException(Marshal.GetLastPInvokeErrorMessage());
        Device = string.Create(CultureInfo.InvariantCulture, $"/dev/pts/{number}");
    }

    /// <summary>The path that a link opens.</summary>
    public string Device { get; }

    /// <summary>Sends back what arrives, on a thread, until the link and this side are closed.</summary>
    public void Echo() => new Thread(Answer) { IsBackground = true, Name = "echo" }.Start();

    public void Send(ReadOnlySpan<byte> bytes) => _master.Write(bytes);

    /// <summary>The cable is unplugged: the link gets a hang-up.</summary>
    public void Dispose() => _master.Dispose();

    private void Answer()
    {
        var bytes = new byte[256];
        try
        {
            while (_master.Read(bytes, 0, bytes.Length) is > 0 and var count) Send(bytes.AsSpan(0, count));
        }
        catch (Exception closed) when (closed is IOException or ObjectDisposedException)
        {
            // The link or this side was closed.
        }
    }

    [DllImport("libc", EntryPoint = "ioctl", SetLastError = true)]
    private static extern int Control(SafeFileHandle file, nuint request, ref int value);
}
