using System.Globalization;
using System.Text.Json;
using System.Text.Json.Serialization;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Machines.Arming;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Histories;

/// <summary>Result of reading a program back.</summary>
/// <param name="Date">Date, UTC.</param>
/// <param name="MaxDeviation">Millimetres; null when unknown.</param>
/// <param name="Certificate">Full path of its certificate; null for none.</param>
public sealed record HistoryReadBack(bool Ok, DateTimeOffset Date, double? MaxDeviation, string? Certificate);
