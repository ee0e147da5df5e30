using System.Runtime.InteropServices;
using System.Text;
using Engraver.Core.Machines;
using Microsoft.Win32.SafeHandles;
using static Engraver.Links.Serial.SerialNative;

namespace Engraver.Links.Serial;

/// <summary>A device file that is locked against the other programs which lock it; both drivers do so on Linux.</summary>
internal static class SerialFile
{
    /// <param name="inUse">The message if another program, or another link of this one, has locked the device.</param>
    /// <exception cref="ControllerLinkException">The device does not exist, permission is denied, it is not a serial line, or it is in use.</exception>
    public static SafeFileHandle OpenLocked(SerialAddress address, string inUse)
    {
        var device = SerialNative.Open(Encoding.UTF8.GetBytes(address.Device + '\0'), OpenFlags);
        if (device.IsInvalid) throw Failure(address, Wording.Get("SerialDevice.CannotBeOpened")); // before another call overwrites the error code
        try
        {
            if (Lock(device, LockExclusive) != 0) throw new ControllerLinkException(Wording.Get(inUse, address.Device));
            _ = Settings(device, address);
            return device;
        }
        catch (ControllerLinkException)
        {
            device.Dispose();
            throw;
        }
    }

    /// <summary>The present settings of the line.</summary>
    /// <exception cref="ControllerLinkException">The device is not a serial line.</exception>
    public static TerminalAttributes Settings(SafeFileHandle device, SerialAddress address)
    {
        var settings = default(TerminalAttributes);
        return Control(device, GetSettings, ref settings) == 0 ? settings : throw Failure(address, Wording.Get("SerialDevice.NotSerialLine"));
    }

    /// <summary>The reason of the last system call.</summary>
    public static ControllerLinkException Failure(SerialAddress address, string what) =>
        new(Wording.Get("SerialDevice.NoConnection", address.Device, what, Marshal.GetLastPInvokeErrorMessage()));
}
