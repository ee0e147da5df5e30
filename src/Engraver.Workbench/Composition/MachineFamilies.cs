using System.Diagnostics.CodeAnalysis;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Core.Motion;

namespace Engraver.Workbench.Composition;

/// <summary>The families of controllers that a session knows. The machine profile selects the family, the address must be one of that family.</summary>
public sealed class MachineFamilies(IReadOnlyList<MachineFamily> all)
{
    /// <summary>The families of the program: a new one is its driver and one line here.</summary>
    public static MachineFamilies Standard { get; } = new([GalilFamily.Create()]);

    /// <summary>The driver of a machine whose profile names no family; no other place decides this.</summary>
    public static IMachineDriver Default { get; } = GalilFamily.Driver;

    public IReadOnlyList<MachineFamily> All => all;

    /// <summary>Every form of address that one of the families accepts, for messages.</summary>
    public string AddressForms => string.Join(", ", [ControllerAddress.Forms, .. all.SelectMany(family => family.AddressForms)]);

    /// <summary>The message for a text that is not an address.</summary>
    public string NotAnAddress(string text) => ControllerAddress.NotAnAddress(text, AddressForms);

    /// <summary>The driver of a machine profile.</summary>
    public static IMachineDriver DriverOf(MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(profile);
        return profile.Controller as IMachineDriver ?? Default;
    }

    public bool TryParseAddress(string text, [NotNullWhen(true)] out ControllerAddress? address)
    {
        address = ControllerAddress.TryParse(text, out var common) ? common : all.Select(family => family.ParseAddress(text)).FirstOrDefault(own => own is not null);
        return address is not null;
    }

    /// <summary>Reads a profile and checks it against the limits of the family that it names.</summary>
    public MachineProfileReadResult ReadProfile(string json) => MachineProfileFile.Read(json, Default.Limits, [.. all.Select(family => family.Driver)]);

    /// <summary>The family by whose driver a controller at an address is used.</summary>
    /// <param name="profile">The profile of the machine; null where none is known: the first family that accepts the address.</param>
    /// <exception cref="ControllerLinkException">The family of the profile is not reached at such an address.</exception>
    /// <exception cref="ArgumentException">No family is reached at such an address.</exception>
    public MachineFamily At(ControllerAddress address, MachineProfile? profile)
    {
        ArgumentNullException.ThrowIfNull(address);
        if (profile is null) return all.FirstOrDefault(family => family.Accepts(address)) ?? throw new ArgumentException($"No family of controllers is reached at {address.Typed}.", nameof(address));
        var driver = DriverOf(profile);
        return all.FirstOrDefault(family => family.Driver.Key == driver.Key && family.Accepts(address)) ?? throw new ControllerLinkException(Wording.Get("MachineFamilies.NotReached", driver.Name, address.Typed));
    }
}
