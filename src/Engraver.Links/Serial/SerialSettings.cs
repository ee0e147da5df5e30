using System.Diagnostics;
using Engraver.Core.Machines;
using static Engraver.Links.Serial.SerialNative;

namespace Engraver.Links.Serial;

/// <summary>Line settings of the kernel: eight data bits, no parity, one stop bit, every byte unchanged (cfmakeraw), a rate and a flow control.</summary>
internal static class SerialSettings
{
    // Names of termios.h for the values.
    private const uint InputTransforms = 0x1 | 0x2 | 0x8 | 0x10 | 0x20 | 0x40 | 0x80 | 0x100; // IGNBRK BRKINT PARMRK INPCK ISTRIP INLCR IGNCR ICRNL
    private const uint InputFlow = 0x400 | 0x800 | 0x1000; // IXON IXANY IXOFF
    private const uint InputXonXoff = 0x400 | 0x1000; // IXON IXOFF
    private const uint OutputTransforms = 0x1; // OPOST
    private const uint LocalProcessing = 0x1 | 0x2 | 0x8 | 0x40 | 0x8000; // ISIG ICANON ECHO ECHONL IEXTEN
    private const uint RateMask = 0x100F; // CBAUD
    private const uint InputRateMask = 0x100F0000; // CIBAUD: the input runs at the output's rate
    private const uint Framing = 0x30 | 0x40 | 0x100; // CSIZE CSTOPB PARENB
    private const uint EightBits = 0x30; // CS8
    private const uint Receiver = 0x80 | 0x800; // CREAD CLOCAL: the controller drives no carrier line
    private const uint HardwareFlow = 0x80000000; // CRTSCTS

    /// <summary>The supported rates: those of a controller, and lower ones for controls that receive programs as plain text.</summary>
    public static bool IsSupported(int baud) => baud is 110 or 300 or 600 or 2400 or 4800 || SerialLine.Rates.Contains(baud);

    public static TerminalAttributes Apply(TerminalAttributes found, int baud, SerialFlow flow) => found with
    {
        Input = (found.Input & ~(InputTransforms | InputFlow)) | (flow == SerialFlow.XonXoff ? InputXonXoff : 0),
        Output = found.Output & ~OutputTransforms,
        Local = found.Local & ~LocalProcessing,
        Control = (found.Control & ~(RateMask | InputRateMask | Framing | HardwareFlow)) | Rate(baud) | EightBits | Receiver | (flow == SerialFlow.RtsCts ? HardwareFlow : 0),
        ReadTime = 0,
        ReadMinimum = 1, // with 0 a read without bytes would return 0, like after a hang-up
        Start = 0x11,
        Stop = 0x13,
    };

    /// <summary>True when the device has accepted the rate.</summary>
    public static bool HasRate(TerminalAttributes settings, int baud) => (settings.Control & RateMask) == Rate(baud);

    /// <summary>The kernel's code for a rate (B1200 and so on).</summary>
    private static uint Rate(int baud) => baud switch
    {
        110 => 0x3,
        300 => 0x7,
        600 => 0x8,
        1200 => 0x9,
        2400 => 0xB,
        4800 => 0xC,
        9600 => 0xD,
        19200 => 0xE,
        38400 => 0xF,
        57600 => 0x1001,
        115200 => 0x1002,
        _ => throw new UnreachableException(),
    };
}
