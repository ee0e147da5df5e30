using System.Runtime.InteropServices;
using System.Text;
using Engraver.Core.Machines;
using Engraver.Galil.Links;
using Microsoft.Win32.SafeHandles;

namespace Engraver.Galil.Tests.Links;

/// <summary>A serial cable without a controller: the test sits at the other end.</summary>
internal sealed class PseudoTerminalPair : IDisposable
{
    private readonly SafeFileHandle _master = Native.OpenMaster(0x2 | 0x100); // O_RDWR O_NOCTTY

    public PseudoTerminalPair()
    {
        var name = new byte[128];
        if (_master.IsInvalid || Native.Grant(_master) != 0 || Native.Unlock(_master) != 0 || Native.NameOf(_master, name, (nuint)name.Length) != 0)
            throw new InvalidOperationException($"No pseudo-terminal: {Marshal.GetLastPInvokeErrorMessage()}");
        Device = Encoding.ASCII.GetString(name, 0, Array.IndexOf(name, (byte)0));
    }

    public string Device { get; }

    /// <param name="time">A clock of the test's, on which a line that takes no byte is given up after 2 s; null for the wall's, which a busy computer must not run out of.</param>
    public SerialLink Open(TimeProvider? time = null) => SerialLink.Open(new SerialAddress(Device, 19200), TimeSpan.FromSeconds(time is null ? 60 : 2), time ?? TimeProvider.System);

    public void Say(string text)
    {
        var bytes = Encoding.Latin1.GetBytes(text);
        Assert.Equal(bytes.Length, Native.Write(_master, bytes, (nuint)bytes.Length));
    }

    /// <summary>Waits for so many bytes of the link.</summary>
    public string Hear(int count)
    {
        var heard = new StringBuilder();
        var bytes = new byte[count];
        while (heard.Length < count)
        {
            var read = (int)Native.Read(_master, bytes, (nuint)(count - heard.Length));
            Assert.InRange(read, 1, count);
            heard.Append(Encoding.Latin1.GetString(bytes, 0, read));
        }

        return heard.ToString();
    }

    /// <summary>Pulls the cable, or the adapter.</summary>
    public void Dispose() => _master.Dispose();

    private static class Native
    {
        [DllImport("libc", EntryPoint = "posix_openpt", SetLastError = true)]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        public static extern SafeFileHandle OpenMaster(int flags);

        [DllImport("libc", EntryPoint = "grantpt", SetLastError = true)]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        public static extern int Grant(SafeFileHandle master);

        [DllImport("libc", EntryPoint = "unlockpt", SetLastError = true)]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        public static extern int Unlock(SafeFileHandle master);

        [DllImport("libc", EntryPoint = "ptsname_r", SetLastError = true)]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        public static extern int NameOf(SafeFileHandle master, byte[] name, nuint length);

        [DllImport("libc", EntryPoint = "read", SetLastError = true)]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        public static extern nint Read(SafeFileHandle master, byte[] bytes, nuint count);

        [DllImport("libc", EntryPoint = "write", SetLastError = true)]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        public static extern nint Write(SafeFileHandle master, byte[] bytes, nuint count);
    }
}
