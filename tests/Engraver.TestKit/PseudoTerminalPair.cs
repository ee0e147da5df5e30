using System.Runtime.InteropServices;
using System.Text;
using Microsoft.Win32.SafeHandles;

namespace Engraver.TestKit;

/// <summary>A serial cable without a controller: the test uses the other end.</summary>
public sealed class PseudoTerminalPair : IDisposable
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

    public void Write(string text)
    {
        var bytes = Encoding.Latin1.GetBytes(text);
        if (Native.Write(_master, bytes, (nuint)bytes.Length) != bytes.Length) throw new InvalidOperationException("The terminal did not take what was said.");
    }

    /// <summary>Waits for the given number of bytes from the link.</summary>
    public string Read(int count)
    {
        var heard = new StringBuilder();
        while (heard.Length < count)
        {
            heard.Append(ReadSome(count - heard.Length) is { Length: > 0 } some ? some : throw new InvalidOperationException("The other side has left."));
        }

        return heard.ToString();
    }

    /// <summary>Waits for bytes from the other side and returns at most the given number; empty when the other side is closed.</summary>
    public string ReadSome(int most)
    {
        var bytes = new byte[most];
        var read = (int)Native.Read(_master, bytes, (nuint)most);
        return read > 0 ? Encoding.Latin1.GetString(bytes, 0, read) : "";
    }

    /// <summary>Unplugs the cable or the adapter.</summary>
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
