using Engraver.Core.Languages;

namespace Engraver.Workbench;

/// <summary>The texts of this project.</summary>
internal sealed class Wording : ProjectTexts<Wording>;
