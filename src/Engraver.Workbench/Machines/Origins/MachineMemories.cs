using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>Storage of the work origins of machines: one file for each, used by one host at a time.</summary>
/// <param name="folder">Null: nothing is stored between connections, as for a simulated machine.</param>
public sealed class MachineMemories(string? folder)
{
    /// <summary>The folder beside the journals of a folder; null for the operator's data folder.</summary>
    public static string FolderIn(string? journals) => Path.Combine(journals ?? UserFiles.Folder, "machines");

    /// <summary>Acquires the lease of a machine: no other host that uses these files can move it until the lease is disposed.</summary>
    /// <param name="address">Address of the controller.</param>
    /// <param name="owner">Name of the owner for the messages of other hosts.</param>
    /// <exception cref="MachineInUseException">Another host uses it.</exception>
    /// <exception cref="MachineMemoryException">The stored state cannot be read, or the folder cannot be written.</exception>
    public MachineLease Acquire(string address, MachineIdentity identity, ControllerPosition place, string owner)
    {
        ArgumentNullException.ThrowIfNull(identity);
        ArgumentNullException.ThrowIfNull(place);
        if (folder is null) return new MachineLease();
        var name = place.Serial is { } serial ? Wording.Get("Origins.SerialNumber", identity.Model, serial) : Wording.Get("Origins.At", identity.Model, address);
        var path = Path.Combine(folder, KeyOf(address, identity, place) + ".json");
        try
        {
            Directory.CreateDirectory(folder);
            var hold = new MachineLease(path, name, MachineLock.Acquire(path, name, owner));
            hold.CompareZero(place); // A lost position remains recorded, whatever happens afterwards.
            return hold;
        }
        catch (Exception unusable) when (unusable is IOException or UnauthorizedAccessException or InvalidDataException)
        {
            throw new MachineMemoryException(Wording.Get("Origins.Unreadable", name, path, SystemErrorText.FromException(unusable)), unusable);
        }
    }

    /// <summary>The file name of a controller: a hash of its model and its serial number, or of its model and its address if it has none.</summary>
    private static string KeyOf(string address, MachineIdentity identity, ControllerPosition place) =>
        Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes($"{identity.Model}\n{place.Serial?.ToString(CultureInfo.InvariantCulture) ?? address}")))[..24];
}
