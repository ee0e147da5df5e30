using System.Runtime.InteropServices;
using System.Text;
using Microsoft.Win32.SafeHandles;

[assembly: DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]

namespace Engraver.Simulator.Protocol;

/// <summary>A Linux pseudo-terminal: the simulator opens the master, and a host opens the slave like a serial device.</summary>
/// <remarks>The simulator keeps the slave open too. A host that disconnects is therefore not detected, as on a real RS-232 line, and the next host finds the
/// terminal's settings unchanged.</remarks>
internal sealed class PseudoTerminal : IDisposable
{
    private const int ReadWriteNoTerminal = 0x2 | 0x100; // O_RDWR O_NOCTTY
    private const int NonBlocking = 0x800;
    private const int CloseOnExec = 0x80000;
    private const nuint GetSettings = 0x5401;
    private const nuint SetSettings = 0x5402;
    private const short PollIn = 1;
    private const short PollGone = 0x8 | 0x10 | 0x20;

    private readonly SafeFileHandle _master;
    private readonly SafeFileHandle _slave;
    private readonly SafeFileHandle _bell;
    private readonly Watched[] _watched;

    private PseudoTerminal(SafeFileHandle master, SafeFileHandle slave, SafeFileHandle bell, string name)
    {
        (_master, _slave, _bell, SlaveName) = (master, slave, bell, name);
        _watched = [.. new[] { master, bell }.Select(file => new Watched { File = (int)file.DangerousGetHandle(), Wanted = PollIn })];
    }

    /// <summary>The device that a host opens, for example <c>/dev/pts/3</c>.</summary>
    public string SlaveName { get; }

    /// <exception cref="IOException">The system has no free terminal.</exception>
    public static PseudoTerminal Open()
    {
        var master = Native.OpenMaster(ReadWriteNoTerminal | NonBlocking | CloseOnExec);
        var name = new byte[128];
        if (master.IsInvalid || Native.Grant(master) != 0 || Native.Unlock(master) != 0 || Native.NameOf(master, name, (nuint)name.Length) != 0) throw Failure();
        var slave = Native.Open(name, ReadWriteNoTerminal | CloseOnExec);
        var bell = Native.EventFd(0, CloseOnExec | NonBlocking);
        if (slave.IsInvalid || bell.IsInvalid || !PassesEveryByte(slave)) throw Failure();
        return new PseudoTerminal(master, slave, bell, Encoding.UTF8.GetString(name, 0, Array.IndexOf(name, (byte)0)));
    }

    /// <summary>Waits for bytes of the host.</summary>
    /// <returns>Number of bytes read; 0 after <see cref="Ring"/>.</returns>
    /// <exception cref="IOException">The terminal no longer exists.</exception>
    public int WaitAndRead(Span<byte> buffer)
    {
        while (true)
        {
            if (Native.Poll(_watched, (nuint)_watched.Length, -1) < 0) continue; // interrupted by a signal
            if (_watched[1].Happened != 0) return 0;
            if (Native.Read(_master, ref MemoryMarshal.GetReference(buffer), (nuint)buffer.Length) is > 0 and var count) return (int)count;
            if ((_watched[0].Happened & PollGone) != 0) throw Failure();
        }
    }

    /// <summary>Writes to the host; returns the number of bytes taken, 0 when the buffer is full.</summary>
    public int Write(ReadOnlySpan<byte> bytes) => (int)Math.Max(0, Native.Write(_master, ref MemoryMarshal.GetReference(bytes), (nuint)bytes.Length));

    /// <summary>Ends <see cref="WaitAndRead"/>, from any thread.</summary>
    public void Ring()
    {
        ulong one = 1;
        try
        {
            _ = Native.Write(_bell, ref MemoryMarshal.AsBytes(new Span<ulong>(ref one))[0], sizeof(ulong));
        }
        catch (ObjectDisposedException)
        {
            // The wait has already ended.
        }
    }

    /// <summary>Closes the terminal; a host that has the slave open sees a hang-up.</summary>
    public void Dispose()
    {
        _master.Dispose();
        _slave.Dispose();
        _bell.Dispose();
    }

    /// <summary>Sets raw mode: switches the kernel's echo and line editing off, for hosts that do not configure the line.</summary>
    private static bool PassesEveryByte(SafeFileHandle slave)
    {
        var settings = default(LineSettings);
        if (Native.Control(slave, GetSettings, ref settings) != 0) return false;
        settings.Input = 0;
        settings.Output = 0;
        settings.Local = 0;
        return Native.Control(slave, SetSettings, ref settings) == 0;
    }

    private static IOException Failure() => new($"No pseudo-terminal: {Marshal.GetLastPInvokeErrorMessage()}.");

    [StructLayout(LayoutKind.Sequential)]
    private struct Watched
    {
        public int File;
        public short Wanted;
        public short Happened;
    }

    /// <summary>struct termios of the kernel (asm-generic, TCGETS), of which only the flags are changed.</summary>
    [StructLayout(LayoutKind.Sequential, Size = 36)]
    private struct LineSettings
    {
        public uint Input;
        public uint Output;
        public uint Control;
        public uint Local;
    }

    private static class Native
    {
        [DllImport("libc", EntryPoint = "posix_openpt", SetLastError = true)]
        public static extern SafeFileHandle OpenMaster(int flags);

        [DllImport("libc", EntryPoint = "grantpt", SetLastError = true)]
        public static extern int Grant(SafeFileHandle master);

        [DllImport("libc", EntryPoint = "unlockpt", SetLastError = true)]
        public static extern int Unlock(SafeFileHandle master);

        [DllImport("libc", EntryPoint = "ptsname_r", SetLastError = true)]
        public static extern int NameOf(SafeFileHandle master, byte[] name, nuint length);

        [DllImport("libc", EntryPoint = "open", SetLastError = true)]
        public static extern SafeFileHandle Open(byte[] path, int flags);

        [DllImport("libc", EntryPoint = "eventfd", SetLastError = true)]
        public static extern SafeFileHandle EventFd(uint initial, int flags);

        [DllImport("libc", EntryPoint = "ioctl", SetLastError = true)]
        public static extern int Control(SafeFileHandle file, nuint request, ref LineSettings settings);

        [DllImport("libc", EntryPoint = "poll", SetLastError = true)]
        public static extern int Poll([In, Out] Watched[] files, nuint count, int milliseconds);

        [DllImport("libc", EntryPoint = "read", SetLastError = true)]
        public static extern nint Read(SafeFileHandle file, ref byte bytes, nuint count);

        [DllImport("libc", EntryPoint = "write", SetLastError = true)]
        public static extern nint Write(SafeFileHandle file, ref byte bytes, nuint count);
    }
}
