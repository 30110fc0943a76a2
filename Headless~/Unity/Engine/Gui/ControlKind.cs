namespace StandIns;

/// <summary>What a control of a drawn inspector is.</summary>
[Unity.StandIns.StandInExtension]
public enum ControlKind
{
    Field,
    Label,
    Button,
    Toggle,
    Foldout,
    HelpBox,
    Area,
}
