using System.Runtime.InteropServices;
using Microsoft.Win32.SafeHandles;

[assembly: DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]

namespace Engraver.Links.Serial;

/// <summary>The system calls for a serial line on Linux. The line settings use ioctl with the kernel's own structure, because termios of libc differs between
/// versions.</summary>
internal static class SerialNative
{
    public const short PollIn = 0x0001;
    public const short PollOut = 0x0004;

    /// <summary>POLLERR, POLLHUP and POLLNVAL: the device was removed.</summary>
    public const short PollGone = 0x0008 | 0x0010 | 0x0020;

    public const int Interrupted = 4;
    public const int TryAgain = 11;

    /// <summary>O_RDWR, O_NOCTTY (a hang-up must not end the program), O_NONBLOCK (opening must not wait for a carrier), O_CLOEXEC.</summary>
    public const int OpenFlags = 0x2 | 0x100 | 0x800 | 0x80000;

    /// <summary>LOCK_EX and LOCK_NB.</summary>
    public const int LockExclusive = 2 | 4;

    public const nuint GetSettings = 0x5401;
    public const nuint SetSettings = 0x5402;
    public const nuint Flush = 0x540B;

    /// <summary>TIOCOUTQ: bytes in the output queue.</summary>
    public const nuint OutputQueue = 0x5411;

    public const nint FlushInput = 0;
    public const nint FlushBoth = 2;

    /// <summary>EFD_CLOEXEC and EFD_NONBLOCK.</summary>
    public const int EventFlags = 0x80000 | 0x800;

    [DllImport("libc", EntryPoint = "open", SetLastError = true)]
    public static extern SafeFileHandle Open(byte[] path, int flags);

    [DllImport("libc", EntryPoint = "eventfd", SetLastError = true)]
    public static extern SafeFileHandle EventFd(uint initial, int flags);

    [DllImport("libc", EntryPoint = "flock", SetLastError = true)]
    public static extern int Lock(SafeFileHandle file, int operation);

    [DllImport("libc", EntryPoint = "ioctl", SetLastError = true)]
    public static extern int Control(SafeFileHandle file, nuint request, ref TerminalAttributes settings);

    [DllImport("libc", EntryPoint = "ioctl", SetLastError = true)]
    public static extern int Control(SafeFileHandle file, nuint request, nint argument);

    [DllImport("libc", EntryPoint = "ioctl", SetLastError = true)]
    public static extern int Control(SafeFileHandle file, nuint request, ref int count);

    [DllImport("libc", EntryPoint = "read", SetLastError = true)]
    public static extern nint Read(SafeFileHandle file, ref byte bytes, nuint count);

    [DllImport("libc", EntryPoint = "write", SetLastError = true)]
    public static extern nint Write(SafeFileHandle file, ref byte bytes, nuint count);

    [DllImport("libc", EntryPoint = "poll", SetLastError = true)]
    public static extern int Poll([In, Out] PollDescriptor[] files, nuint count, int milliseconds);

    /// <summary>struct pollfd.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct PollDescriptor
    {
        public int File;
        public short Wanted;
        public short Happened;
    }

    /// <summary>struct termios of the kernel (asm-generic, TCGETS): 36 bytes. Three words hold the control characters; the first seven are used.</summary>
    [StructLayout(LayoutKind.Sequential, Size = 36)]
    public struct TerminalAttributes
    {
        public uint Input;
        public uint Output;
        public uint Control;
        public uint Local;
        public byte Discipline;
        public byte Interrupt;
        public byte QuitCharacter;
        public byte Erase;
        public byte Kill;
        public byte EndOfFile;
        public byte ReadTime;
        public byte ReadMinimum;
        public byte SwitchCharacter;
        public byte Start;
        public byte Stop;
    }
}
