using System.Text.Json;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Links.Serial;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Composition;

/// <summary>Looks which controllers answer: at addresses that are given, at the one that the desktop used last, and at the serial devices of this computer.
/// Nothing is moved.</summary>
public static class Discovery
{
    /// <summary>Nobody waits longer for one address.</summary>
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(4);

    /// <summary>Where to look, each address once, in the order in which it was found.</summary>
    /// <param name="baud">Rate of the serial devices.</param>
    /// <param name="settings">File of the desktop's settings; it is only read.</param>
    public static IReadOnlyList<string> Candidates(IEnumerable<string> given, int baud, string settings, IEnumerable<string> devices)
    {
        ArgumentNullException.ThrowIfNull(devices);
        var serial = devices.Select(device => FormattableString.Invariant($"serial://{device}?baud={baud}"));
        return [.. given.Concat(Remembered(settings) is { } last ? [last] : []).Concat(serial).Distinct(StringComparer.Ordinal)];
    }

    /// <summary>The serial devices of this computer.</summary>
    public static IReadOnlyList<string> Devices => SerialDeviceList.Find();

    /// <summary>The desktop's settings of this user.</summary>
    public static string UserSettings => UserFiles.DesktopSettingsFile;

    /// <summary>Asks one address who is there.</summary>
    /// <param name="time">The clock of the patience.</param>
    public static async Task<DiscoveredController> AskAsync(string address, TimeProvider time, CancellationToken cancellation)
    {
        if (!MachineFamilies.Standard.TryParseAddress(address, out var parsed)) return new DiscoveredController(address, null, null, MachineFamilies.Standard.NotAnAddress(address));
        using var patience = new CancellationTokenSource(s_patience, time);
        using var either = CancellationTokenSource.CreateLinkedTokenSource(patience.Token, cancellation);
        try
        {
            await using var connection = MachineConnection.To(parsed, time);
            await using var machine = await connection.ShakeHandsAsync(time, either.Token).ConfigureAwait(false);
            var place = await machine.LocateAsync(MachineAxes.Default, either.Token).ConfigureAwait(false);
            return new DiscoveredController(address, machine.Identity.Model, place.Serial, null);
        }
        catch (Exception silent) when (silent is ControllerException or PlatformNotSupportedException or IOException or UnauthorizedAccessException)
        {
            return new DiscoveredController(address, null, null, SystemReason.Of(silent));
        }
        catch (OperationCanceledException) when (!cancellation.IsCancellationRequested)
        {
            return new DiscoveredController(address, null, null, Wording.Get("Discovery.NoAnswer", s_patience.TotalSeconds));
        }
    }

    /// <summary>The last address of the desktop that is not a simulated controller; null when there is none, or the file cannot be read.</summary>
    private static string? Remembered(string settings)
    {
        try
        {
            if (!File.Exists(settings)) return null;
            using var document = JsonDocument.Parse(File.ReadAllText(settings));
            return document.RootElement.ValueKind == JsonValueKind.Object && document.RootElement.TryGetProperty("lastAddress", out var last) && last.ValueKind == JsonValueKind.String
                && MachineFamilies.Standard.TryParseAddress(last.GetString()!, out var address) && address is not SimulatedAddress ? last.GetString() : null;
        }
        catch (Exception unreadable) when (unreadable is JsonException or IOException or UnauthorizedAccessException)
        {
            return null;
        }
    }
}

/// <summary>What came of asking an address.</summary>
/// <param name="Model">As the controller names itself; null where none answers.</param>
/// <param name="Serial">Its own serial number; null where it has none.</param>
/// <param name="WhyNot">Why nobody was found there; null where a controller answers.</param>
public sealed record DiscoveredController(string Address, string? Model, long? Serial, string? WhyNot);
