namespace Engraver.Core.Machines;

/// <summary>What opens a serial device.</summary>
public enum SerialDriver : byte
{
    /// <summary>This program's own use of the kernel's interface, on Linux.</summary>
    Own,

    /// <summary>The library System.IO.Ports: Windows, macOS and, by choice, Linux.</summary>
    Ports,
}
