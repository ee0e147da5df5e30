using System.Runtime.InteropServices;
using Engraver.Core.Machines;
using Microsoft.Win32.SafeHandles;
using static Engraver.Links.Serial.SerialNative;

namespace Engraver.Links.Serial;

/// <summary>An open serial device, with an event that wakes the waiting thread. No method blocks except <see cref="Wait"/>.</summary>
internal sealed class SerialDevice : IDisposable
{
    private readonly SafeFileHandle _device;
    private readonly SafeFileHandle _bell;
    private readonly PollDescriptor[] _watched;

    private SerialDevice(SafeFileHandle device, SafeFileHandle bell)
    {
        _device = device;
        _bell = bell;
        _watched = [new PollDescriptor { File = (int)device.DangerousGetHandle() }, new PollDescriptor { File = (int)bell.DangerousGetHandle(), Wanted = PollIn }];
    }

    /// <summary>Opens the device exclusively and sets the line. Bytes that another program left unread are dropped.</summary>
    /// <exception cref="ControllerLinkException">The device does not exist, permission is denied, another program uses it, or it does not support the
    /// rate.</exception>
    public static SerialDevice Open(SerialAddress address)
    {
        var device = SerialFile.OpenLocked(address, "SerialDevice.InUse");
        var bell = EventFd(0, EventFlags);
        try
        {
            if (bell.IsInvalid) throw SerialFile.Failure(address, Wording.Get("SerialDevice.CannotBeOpened"));
            Configure(device, address);
            return new SerialDevice(device, bell);
        }
        catch (ControllerLinkException)
        {
            device.Dispose();
            bell.Dispose();
            throw;
        }
    }

    /// <summary>Waits until bytes can be read, until bytes can be sent (when <paramref name="toSend"/>), or until <see cref="Ring"/>.</summary>
    /// <returns>The events of the device, as flags of poll.</returns>
    public short Wait(bool toSend)
    {
        _watched[0].Wanted = toSend ? (short)(PollIn | PollOut) : PollIn;
        while (Poll(_watched, (nuint)_watched.Length, -1) < 0)
        {
            if (Marshal.GetLastPInvokeError() != Interrupted) return PollGone;
        }

        if (_watched[1].Happened != 0) ResetBell();
        return _watched[0].Happened;
    }

    /// <summary>Ends a wait from any thread.</summary>
    public void Ring()
    {
        ulong one = 1;
        _ = SerialNative.Write(_bell, ref MemoryMarshal.AsBytes(new Span<ulong>(ref one))[0], sizeof(ulong));
    }

    /// <summary>Number of bytes read; 0 when there are none.</summary>
    /// <exception cref="IOException">The device was removed.</exception>
    public int Read(Span<byte> bytes)
    {
        var count = SerialNative.Read(_device, ref MemoryMarshal.GetReference(bytes), (nuint)bytes.Length);
        return count switch
        {
            > 0 => (int)count,
            0 => throw new IOException(Wording.Get("SerialLink.DeviceDisconnected")),
            _ => ZeroOrThrow(Marshal.GetLastPInvokeError()),
        };
    }

    /// <summary>Writes bytes; returns how many were accepted, 0 when the buffer is full.</summary>
    /// <exception cref="IOException">The device was removed.</exception>
    public int Write(ReadOnlySpan<byte> bytes)
    {
        var count = SerialNative.Write(_device, ref MemoryMarshal.GetReference(bytes), (nuint)bytes.Length);
        return count >= 0 ? (int)count : ZeroOrThrow(Marshal.GetLastPInvokeError());
    }

    /// <summary>Number of accepted bytes that are not sent yet; 0 if the device does not report it.</summary>
    public int Unsent
    {
        get
        {
            var count = 0;
            return Control(_device, OutputQueue, ref count) == 0 ? count : 0;
        }
    }

    /// <summary>True when closing sends the remaining bytes instead of dropping them; only for a line that has just accepted everything.</summary>
    public bool DrainsOnClose { get; set; }

    /// <summary>Closes the device. Unsent bytes are dropped first unless they are to be kept, because closing would wait for them, for a long time if the other
    /// side has stopped the flow.</summary>
    public void Dispose()
    {
        if (!DrainsOnClose) _ = Control(_device, Flush, FlushBoth);
        _device.Dispose();
        _bell.Dispose();
    }

    private static void Configure(SafeFileHandle device, SerialAddress address)
    {
        var settings = SerialSettings.Apply(SerialFile.Settings(device, address), address.Baud, address.Flow);
        if (Control(device, SetSettings, ref settings) != 0) throw SerialFile.Failure(address, Wording.Get("SerialDevice.CannotBeConfigured"));
        if (Control(device, GetSettings, ref settings) != 0 || !SerialSettings.HasRate(settings, address.Baud))
            throw new ControllerLinkException(Wording.Get("SerialDevice.UnsupportedBaud", address.Device, address.Baud));
        _ = Control(device, Flush, FlushInput);
    }

    private void ResetBell()
    {
        ulong count = 0;
        _ = SerialNative.Read(_bell, ref MemoryMarshal.AsBytes(new Span<ulong>(ref count))[0], sizeof(ulong));
    }

    private static int ZeroOrThrow(int error) =>
        error is TryAgain or Interrupted ? 0 : throw new IOException(Marshal.GetPInvokeErrorMessage(error));
}
