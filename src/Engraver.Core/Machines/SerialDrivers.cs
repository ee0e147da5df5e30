namespace Engraver.Core.Machines;

/// <summary>The option <c>driver=</c> of an address: the names of the drivers of serial devices.</summary>
public static class SerialDrivers
{
    private const string Option = "driver=";

    /// <summary>The names, for messages.</summary>
    public static string Names => string.Join(", ", Enum.GetValues<SerialDriver>().Select(Name));

    public static string Name(SerialDriver driver) => driver == SerialDriver.Own ? "own" : "ports";

    /// <summary>The option as part of an address after other options; empty for the default driver of the system.</summary>
    public static string OptionText(SerialDriver? driver) => driver is { } chosen ? $"&{Option}{Name(chosen)}" : "";

    /// <summary>The driver of an option; null if the option is another one or its driver is unknown.</summary>
    public static SerialDriver? Find(string option) => Enum.GetValues<SerialDriver>().Select(driver => (SerialDriver?)driver).FirstOrDefault(driver => option == Option + Name(driver!.Value));

    /// <summary>The unknown driver that an address names; null if it names none.</summary>
    public static string? UnknownIn(string address)
    {
        ArgumentNullException.ThrowIfNull(address);
        return address.Split('?', '&').FirstOrDefault(option => option.StartsWith(Option, StringComparison.Ordinal) && Find(option) is null)?[Option.Length..];
    }
}
