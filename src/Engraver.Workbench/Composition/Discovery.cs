using System.Text.Json;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Links.Serial;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Composition;

/// <summary>Finds controllers that answer: at given addresses, at the last address of the desktop, and at the serial devices of this computer. Does not move a
/// machine.</summary>
public static class Discovery
{
    /// <summary>Timeout for one address.</summary>
    private static readonly TimeSpan s_timeout = TimeSpan.FromSeconds(4);

    /// <summary>The addresses to query, without duplicates, in the order in which they were found.</summary>
    /// <param name="baud">Baud rate of the serial devices.</param>
    /// <param name="settings">File of the desktop's settings; it is only read.</param>
    public static IReadOnlyList<string> Candidates(IEnumerable<string> given, int baud, string settings, IEnumerable<string> devices)
    {
        ArgumentNullException.ThrowIfNull(devices);
        var serial = devices.Select(device => FormattableString.Invariant($"serial://{device}?baud={baud}"));
        return [.. given.Concat(LastAddress(settings) is { } last ? [last] : []).Concat(serial).Distinct(StringComparer.Ordinal)];
    }

    /// <summary>The serial devices of this computer.</summary>
    public static IReadOnlyList<string> Devices => SerialDeviceList.Present;

    /// <summary>The desktop's settings file of this user.</summary>
    public static string UserSettings => UserFiles.DesktopSettingsFile;

    /// <summary>Queries one address.</summary>
    /// <param name="time">The clock of the timeout.</param>
    public static async Task<DiscoveredController> QueryAsync(string address, TimeProvider time, CancellationToken cancellation)
    {
        if (!MachineFamilies.Standard.TryParseAddress(address, out var parsed)) return new DiscoveredController(address, null, null, MachineFamilies.Standard.NotAnAddress(address));
        using var patience = new CancellationTokenSource(s_timeout, time);
        using var either = CancellationTokenSource.CreateLinkedTokenSource(patience.Token, cancellation);
        try
        {
            await using var connection = MachineConnection.To(parsed, time);
            await using var machine = await connection.HandshakeAsync(time, either.Token).ConfigureAwait(false);
            var place = await machine.ReadPositionAsync(MachineAxes.Default, either.Token).ConfigureAwait(false);
            return new DiscoveredController(address, machine.Identity.Model, place.Serial, null);
        }
        catch (Exception silent) when (silent is ControllerException or PlatformNotSupportedException or IOException or UnauthorizedAccessException)
        {
            return new DiscoveredController(address, null, null, SystemErrorText.FromException(silent));
        }
        catch (OperationCanceledException) when (!cancellation.IsCancellationRequested)
        {
            return new DiscoveredController(address, null, null, Wording.Get("Discovery.NoAnswer", s_timeout.TotalSeconds));
        }
    }

    /// <summary>The last address of the desktop that is not a simulated controller; null when there is none, or the file cannot be read.</summary>
    private static string? LastAddress(string settings)
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
