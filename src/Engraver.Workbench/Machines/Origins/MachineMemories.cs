using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>Where the work origins of machines are kept: one file for each, and one host at a time.</summary>
/// <param name="folder">Null: nothing is kept between connections, as for a simulated machine.</param>
public sealed class MachineMemories(string? folder)
{
    /// <summary>The folder beside the journals of a folder; null for the operator's data folder.</summary>
    public static string FolderIn(string? journals) => Path.Combine(journals ?? UserFiles.Folder, "machines");

    /// <summary>Takes a machine for as long as the hold lives: no other host that goes by these files moves it meanwhile.</summary>
    /// <param name="address">Where the controller is reached.</param>
    /// <param name="holder">Who takes it, for the one who comes second.</param>
    /// <exception cref="MachineTakenException">Another host has it.</exception>
    /// <exception cref="MachineMemoryException">What is kept cannot be read, or the folder cannot be written.</exception>
    public MachineHold Take(string address, MachineIdentity identity, ControllerPlace place, string holder)
    {
        ArgumentNullException.ThrowIfNull(identity);
        ArgumentNullException.ThrowIfNull(place);
        if (folder is null) return new MachineHold();
        var name = place.Serial is { } serial ? Wording.Get("Origins.SerialNumber", identity.Model, serial) : Wording.Get("Origins.At", identity.Model, address);
        var path = Path.Combine(folder, KeyOf(address, identity, place) + ".json");
        try
        {
            Directory.CreateDirectory(folder);
            var hold = new MachineHold(path, name, MachineLock.Take(path, name, holder));
            hold.Recognise(place); // what is lost stays lost, whatever this host is refused and the operator does then
            return hold;
        }
        catch (Exception unusable) when (unusable is IOException or UnauthorizedAccessException or InvalidDataException)
        {
            throw new MachineMemoryException(Wording.Get("Origins.Unreadable", name, path, SystemReason.Of(unusable)), unusable);
        }
    }

    /// <summary>The file name of a controller: a hash of its model and its serial number, or of its model and its address where it tells no number.</summary>
    private static string KeyOf(string address, MachineIdentity identity, ControllerPlace place) =>
        Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes($"{identity.Model}\n{place.Serial?.ToString(CultureInfo.InvariantCulture) ?? address}")))[..24];
}

/// <summary>The machine answers, but this host must not move it: nothing was moved.</summary>
public abstract class MachineUnavailableException : ControllerException
{
    protected MachineUnavailableException()
    {
    }

    protected MachineUnavailableException(string message)
        : base(message)
    {
    }

    protected MachineUnavailableException(string message, Exception inner)
        : base(message, inner)
    {
    }
}

/// <summary>Another host uses the machine.</summary>
public sealed class MachineTakenException : MachineUnavailableException
{
    public MachineTakenException()
    {
    }

    public MachineTakenException(string message)
        : base(message)
    {
    }

    public MachineTakenException(string message, Exception inner)
        : base(message, inner)
    {
    }
}

/// <summary>What is kept of a machine cannot be used. Without it nobody knows where the work is, so nothing is moved.</summary>
public sealed class MachineMemoryException : MachineUnavailableException
{
    public MachineMemoryException()
    {
    }

    public MachineMemoryException(string message)
        : base(message)
    {
    }

    public MachineMemoryException(string message, Exception inner)
        : base(message, inner)
    {
    }

    /// <summary>Nothing is moved when nobody could say afterwards where the machine is.</summary>
    internal static MachineMemoryException NotWritten(string failure) => new(Wording.Get("Origins.NotWritten", failure));
}
